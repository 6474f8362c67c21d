//! The expansion of the macro as a file of Rust.

use crate::names::snake_case;
use dynamics_codegen::{Model, items_of};
use proc_macro2::{Ident, Span};
use quote::{format_ident, quote};
use syn::{Item, ItemMacro};

/// The crate that the file's own crate depends on.
const FACADE: &str = "::robot_dynamics";

/// The name of the file, and its text, for the robot of a file of that name. A name that was given for the struct is taken
/// as it is, if it can be.
///
/// # Errors
///
/// The messages about functions that could not be derived, one a line.
pub(crate) fn source(
    of_file: &str,
    model: Model,
    given: Option<&str>,
) -> Result<(String, String), String> {
    let module = snake_case(&model.robot.name);
    let name = given.and_then(as_struct).unwrap_or(struct_name(&module));
    let documentation = [
        format!(" The arm of `{of_file}`, with its equations of motion."),
        String::new(),
        format!(
            " Joints that move: {}.",
            model
                .robot
                .joints()
                .map(|row| format!("`{}`", row.name))
                .collect::<Vec<_>>()
                .join(", ")
        ),
    ];
    let facade = syn::parse_str(FACADE).map_err(|error| error.to_string())?;
    let items = items_of(model, name, &documentation, facade).map_err(|errors| {
        let messages = errors.iter().map(|error| error.message.as_str());
        messages.collect::<Vec<_>>().join("\n")
    })?;
    let head = format!(
        "// Generated from {of_file} by `robot-dynamics generate --lang rust`: what the macro `robot_dynamics!` expands to\n\
         // for this arm. The crate that it stands in depends on `robot-dynamics`.\n\n"
    );
    let items = syn::parse2(items).map_err(|error| error.to_string())?;
    let text = head + &formatted(items);
    Ok((format!("{module}.rs"), text))
}

/// The name of a struct, if the word is one.
fn as_struct(word: &str) -> Option<Ident> {
    let is_one = word.starts_with(|letter: char| letter.is_uppercase()) && !word.contains('_');
    syn::parse_str(word).ok().filter(|_| is_one)
}

/// `two_link` as `TwoLink`.
fn struct_name(module: &str) -> Ident {
    let words = module.split('_').map(|word| {
        let mut letters = word.chars();
        let first = letters.next().map(|first| first.to_uppercase().to_string());
        first.unwrap_or_default() + letters.as_str()
    });
    let joined: String = words.collect();
    // A name does not start with a digit.
    let starts_well = joined.starts_with(|letter: char| letter.is_alphabetic());
    let letters = if starts_well { "" } else { "Arm" }
        .chars()
        .chain(joined.chars());
    let name: String = letters.filter(char::is_ascii_alphanumeric).collect();
    match syn::parse_str(&name) {
        Ok(name) => name,
        Err(_) => Ident::new("Arm", Span::call_site()),
    }
}

/// The text of the items. Items inside a macro of the runtime are formatted like other items.
fn formatted(mut file: syn::File) -> String {
    let mut macros = Vec::new();
    for item in &mut file.items {
        if let Some((module, path)) = as_module(item, macros.len()) {
            *item = module;
            macros.push(path);
        }
    }
    let mut text = prettyplease::unparse(&file);
    for (index, path) in macros.iter().enumerate() {
        text = text.replace(&format!("mod __macro_{index} {{"), &format!("{path}! {{"));
    }
    spaced(&text)
}

/// A call of a macro that holds items as a module that holds them, and the path of the macro.
fn as_module(item: &Item, index: usize) -> Option<(Item, String)> {
    let Item::Macro(ItemMacro { mac, .. }) = item else {
        return None;
    };
    let items = syn::parse2::<syn::File>(mac.tokens.clone()).ok()?.items;
    let path = &mac.path;
    let path = quote!(#path).to_string().replace(' ', "");
    let name = format_ident!("__macro_{index}");
    let module = syn::parse2(quote!(mod #name { #(#items)* })).ok()?;
    Some((module, path))
}

/// The text with an empty line in front of each documented or attributed item, and of each implementation.
fn spaced(text: &str) -> String {
    let is_head = |line: &str| {
        let line = line.trim_start();
        ["///", "#[", "impl", "mod ", "::robot_dynamics::__with"]
            .iter()
            .any(|start| line.starts_with(start))
    };
    let mut spaced = String::with_capacity(text.len() + text.len() / 20);
    let mut before = "{";
    for line in text.lines() {
        let goes_on =
            before.ends_with('{') || before.trim() == ")]" || is_head(before) || before.is_empty();
        if is_head(line) && !goes_on {
            spaced.push('\n');
        }
        spaced.push_str(line);
        spaced.push('\n');
        before = line;
    }
    spaced
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_structs_are_kept() {
        let kept = ["UR5e", "Arm"].map(|word| as_struct(word).map(|name| name.to_string()));
        assert_eq!(kept, [Some("UR5e".to_owned()), Some("Arm".to_owned())]);
        for word in ["ur5e", "Two_Link", "My arm", "Self"] {
            assert!(as_struct(word).is_none(), "{word}");
        }
    }

    #[test]
    fn structs_have_the_names_of_files() {
        for (name, expected) in [
            ("two_link", "TwoLink"),
            ("UR5e", "Ur5e"),
            ("7bot", "Arm7bot"),
            ("my arm.2", "MyArm2"),
            ("self", "Arm"),
        ] {
            assert_eq!(struct_name(&snake_case(name)).to_string(), expected);
        }
    }
}
