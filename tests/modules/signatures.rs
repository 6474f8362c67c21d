//! The public interface of a crate shows nothing of the engine, whose types may change in any version.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::source::{has_attribute, is_word, read_use, split_item};

/// The crates of the engine.
const ENGINE: [&str; 2] = ["dynamics_symbolic", "dynamics_codegen"];

/// The mistakes of a source's public items: signatures that name something of the engine, and structs that can be built
/// by a literal. Items that are hidden and those of tests are left out.
pub(crate) fn open_items(text: &str) -> Vec<String> {
    let items = items(text.parse().expect("Rust"));
    let mut imports = Vec::new();
    for item in &items {
        if let Some(place) = item.iter().position(|token| is_word(token, "use")) {
            read_use(&item[place + 1..], &[], false, &mut imports);
        }
    }
    let of_engine = imports
        .into_iter()
        .filter(|import| ENGINE.contains(&import.path[0].as_str()));
    // Functions and modules are in lower case, as names of arguments are.
    let is_type = |name: &String| name.starts_with(char::is_uppercase);
    let types = of_engine.map(|import| import.name).filter(is_type);
    let mut engine: Vec<String> = types.collect();
    engine.extend(ENGINE.map(String::from));
    let mut found = Vec::new();
    for item in &items {
        look(item, &engine, &mut found);
    }
    found
}

/// The items of some tokens but for those that are hidden or of tests.
fn items(tokens: TokenStream) -> Vec<Vec<TokenTree>> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let (mut rest, mut items) = (&tokens[..], Vec::new());
    while !rest.is_empty() {
        let (item, after) = split_item(rest);
        rest = after;
        let is_hidden = ["cfg(test)", "doc(hidden)"];
        if !is_hidden.iter().any(|words| has_attribute(item, words)) {
            items.push(item.to_vec());
        }
    }
    items
}

fn look(item: &[TokenTree], engine: &[String], found: &mut Vec<String>) {
    let mut tokens = item;
    while let [TokenTree::Punct(sign), TokenTree::Group(_), rest @ ..] = tokens
        && sign.as_char() == '#'
    {
        tokens = rest;
    }
    let has = |word: &str| tokens.iter().any(|token| is_word(token, word));
    let Some((last, head)) = tokens.split_last() else {
        return;
    };
    if is_word(&tokens[0], "impl") {
        if let TokenTree::Group(body) = last
            && !has("for")
        {
            let methods = items(body.stream());
            methods.iter().for_each(|item| look(item, engine, found));
        }
    } else if !is_public(tokens) {
        return;
    }
    let shown = if has("struct") {
        let fields = public_fields(tokens);
        if !fields.is_empty() && !has_attribute(item, "non_exhaustive") {
            found.push(format!("{}: can be built by a literal", text(head)));
        }
        fields
    } else if has("enum") || has("trait") || has("use") || has("type") {
        names(tokens)
    } else {
        names(head)
    };
    let named = shown.iter().find(|name| engine.contains(name));
    found.extend(named.map(|name| format!("{}: shows `{name}`", text(head))));
}

/// Whether tokens begin with `pub`, and not with `pub(crate)`.
fn is_public(tokens: &[TokenTree]) -> bool {
    let is_limited = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis);
    is_word(&tokens[0], "pub") && !tokens.get(1).is_some_and(is_limited)
}

/// The names in the public fields of a struct.
fn public_fields(item: &[TokenTree]) -> Vec<String> {
    let mut found = Vec::new();
    for token in item {
        if let TokenTree::Group(fields) = token {
            let tokens: Vec<TokenTree> = fields.stream().into_iter().collect();
            let starts = (0..tokens.len()).filter(|i| is_public(&tokens[*i..]));
            for start in starts {
                let length = tokens[start + 1..]
                    .iter()
                    .position(|token| is_word(token, "pub"));
                let end = length.map_or(tokens.len(), |length| start + 1 + length);
                found.extend(names(&tokens[start..end]));
            }
        }
    }
    found
}

/// All names in tokens, those in groups too; of a path the first.
fn names(tokens: &[TokenTree]) -> Vec<String> {
    let is_colon = |token: &TokenTree| token.to_string() == ":";
    let name = |i: usize| match &tokens[i] {
        TokenTree::Group(group) => names(&group.stream().into_iter().collect::<Vec<_>>()),
        _ if i > 1 && tokens[i - 2..i].iter().all(is_colon) => Vec::new(),
        other => vec![other.to_string()],
    };
    (0..tokens.len()).flat_map(name).collect()
}

fn text(tokens: &[TokenTree]) -> String {
    tokens.iter().cloned().collect::<TokenStream>().to_string()
}

/// Or the test of the crates would pass whatever they show.
#[test]
fn open_items_are_found() {
    let text = "
        use dynamics_symbolic::robot::{Robot as Arm, Error, text};
        use dynamics_runtime::Row;
        pub use dynamics_codegen::Audience;
        pub struct Closed { robot: Arm }
        pub struct Open { pub row: Row }
        #[non_exhaustive]
        pub struct Shown(pub dynamics_symbolic::Row);
        pub(crate) struct Inner { pub robot: Arm }
        pub enum Wrong { Arm(Arm) }
        impl core::error::Error for Wrong {}
        impl Closed {
            pub fn robot(&self) -> &Arm { &self.robot }
            #[doc(hidden)]
            pub fn hidden(&self) -> &Arm { &self.robot }
            pub fn of(text: Row) -> Self { let robot: Arm = make(text); Closed { robot } }
            fn private(robot: Arm) {}
        }
        impl From<Arm> for Closed { fn from(robot: Arm) -> Self { Closed { robot } } }
        #[cfg(test)]
        pub fn tested(robot: Arm) {}
    ";
    let found = open_items(text);
    let expected = [
        "Audience",
        "Open",
        "Shown",
        "Wrong",
        "robot (& self)",
        "From",
    ];
    assert_eq!(found.len(), expected.len(), "{found:#?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.contains(expected), "{found}");
    }
}
