//! The files of a crate and the items in them, as tokens.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A crate: its files, and its modules by their paths.
pub(crate) struct Crate {
    pub(crate) files: Vec<File>,
    pub(crate) modules: BTreeMap<Vec<String>, Module>,
}

pub(crate) struct File {
    /// From the folder of the sources, with slashes.
    pub(crate) path: String,
}

/// A module, in a file of its own or within one.
#[derive(Default)]
pub(crate) struct Module {
    pub(crate) file: usize,
    /// The items that it defines, modules left out.
    pub(crate) items: Vec<String>,
    pub(crate) imports: Vec<Import>,
    /// All paths with `::` in its code, and all single names, imports left out.
    pub(crate) paths: Vec<Vec<String>>,
}

/// One name that a `use` brings in; `*` for all of a module.
#[derive(Clone, Debug)]
pub(crate) struct Import {
    pub(crate) name: String,
    pub(crate) path: Vec<String>,
    /// Whether others may find it here: a re-export, which the file need not use itself.
    pub(crate) public: bool,
}

impl Crate {
    /// Reads all modules that are not tests: of a library, of a program, or of both.
    pub(crate) fn read_all(folder: &Path) -> Vec<Self> {
        let roots = ["lib.rs", "main.rs"].into_iter();
        let roots = roots.filter(|root| folder.join(root).exists());
        let crates: Vec<_> = roots.map(|root| Crate::read(folder, root)).collect();
        assert!(!crates.is_empty(), "a library or a program: {folder:?}");
        crates
    }

    fn read(folder: &Path, root: &str) -> Self {
        let mut sources = Crate {
            files: Vec::new(),
            modules: BTreeMap::new(),
        };
        sources.read_file(folder, root, Vec::new());
        sources
    }

    fn read_file(&mut self, folder: &Path, path: &str, module: Vec<String>) {
        let text = fs::read_to_string(folder.join(path)).unwrap_or_else(|e| panic!("{path}: {e}"));
        let tokens: TokenStream = text.parse().unwrap_or_else(|e| panic!("{path}: {e}"));
        let file = self.files.len();
        self.files.push(File {
            path: path.to_owned(),
        });
        let mut children = Vec::new();
        self.read_module(file, &module, tokens, &mut children);
        for child in children {
            // `x.rs` or `x/mod.rs`, in the folder of the module that declares it.
            let inside = child.join("/");
            let path = [format!("{inside}.rs"), format!("{inside}/mod.rs")]
                .into_iter()
                .find(|path| folder.join(path).exists())
                .unwrap_or_else(|| panic!("{inside} has no file"));
            self.read_file(folder, &path, child);
        }
    }

    fn read_module(
        &mut self,
        file: usize,
        path: &[String],
        tokens: TokenStream,
        children: &mut Vec<Vec<String>>,
    ) {
        let mut module = Module {
            file,
            ..Module::default()
        };
        let mut inner = Vec::new();
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut rest = &tokens[..];
        while !rest.is_empty() {
            let (item, after) = split_item(rest);
            rest = after;
            if is_test(item) {
                continue;
            }
            match Item::of(item) {
                Item::Module(name, None) => children.push(joined(path, name)),
                Item::Module(name, Some(body)) => inner.push((joined(path, name), body)),
                Item::Use { public, tree } => read_use(tree, &[], public, &mut module.imports),
                Item::Other(name) => {
                    module.items.extend(name);
                    read_paths(item.iter().cloned().collect(), &mut module);
                }
            }
        }
        self.modules.insert(path.to_vec(), module);
        for (path, body) in inner {
            self.read_module(file, &path, body, children);
        }
    }
}

fn joined(path: &[String], name: String) -> Vec<String> {
    path.iter().cloned().chain([name]).collect()
}

/// The kind of an item.
enum Item<'a> {
    Module(String, Option<TokenStream>),
    Use {
        public: bool,
        tree: &'a [TokenTree],
    },
    /// A definition and its name, or none: an `impl` or a call of a macro.
    Other(Option<String>),
}

impl<'a> Item<'a> {
    fn of(tokens: &'a [TokenTree]) -> Self {
        let mut public = false;
        for (i, token) in tokens.iter().enumerate() {
            let name = || match tokens.get(i + 1) {
                Some(TokenTree::Ident(name)) => Some(name.to_string()),
                _ => None,
            };
            let TokenTree::Ident(word) = token else {
                continue;
            };
            match word.to_string().as_str() {
                "pub" => public = true,
                "use" => {
                    return Item::Use {
                        public,
                        tree: &tokens[i + 1..],
                    };
                }
                "mod" => {
                    let body = match tokens.last() {
                        Some(TokenTree::Group(body)) => Some(body.stream()),
                        _ => None,
                    };
                    return Item::Module(name().expect("the name of a module"), body);
                }
                "struct" | "enum" | "union" | "trait" | "fn" | "static" | "type" => {
                    return Item::Other(name());
                }
                // Not `const fn`.
                "const" => match name().as_deref() {
                    Some("fn" | "unsafe" | "extern" | "async") => {}
                    name => return Item::Other(name.map(str::to_owned)),
                },
                "macro_rules" => {
                    let name = tokens.get(i + 2).map(TokenTree::to_string);
                    return Item::Other(name);
                }
                "impl" => return Item::Other(None),
                _ => {}
            }
        }
        Item::Other(None)
    }
}

/// The first item with its attributes, and what follows: it ends in a semicolon or a block.
pub(crate) fn split_item(tokens: &[TokenTree]) -> (&[TokenTree], &[TokenTree]) {
    let ends = |i: &usize| match &tokens[*i] {
        TokenTree::Punct(sign) => sign.as_char() == ';',
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
            !goes_on_after_a_block(&tokens[..*i])
        }
        _ => false,
    };
    let end = (0..tokens.len()).find(ends);
    tokens.split_at(end.map_or(tokens.len(), |end| end + 1))
}

/// Whether an item that begins so is a `use`, or a constant whose value has a block.
fn goes_on_after_a_block(item: &[TokenTree]) -> bool {
    let has = |word: &&str| item.iter().any(|token| is_word(token, word));
    let is_constant = ["const", "static"].iter().any(has) && item.iter().any(is_equals);
    // `const` stands in these as well.
    let is_generic = ["fn", "impl", "trait", "struct", "enum"].iter().any(has);
    has(&"use") || (is_constant && !is_generic)
}

pub(crate) fn is_word(token: &TokenTree, word: &str) -> bool {
    matches!(token, TokenTree::Ident(name) if name == word)
}

fn is_equals(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(sign) if sign.as_char() == '=')
}

/// Whether an item has the attribute `#[cfg(test)]`.
fn is_test(item: &[TokenTree]) -> bool {
    has_attribute(item, "cfg(test)")
}

/// Whether an item has an attribute of these words.
pub(crate) fn has_attribute(item: &[TokenTree], words: &str) -> bool {
    item.iter().any(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket => {
            group.stream().to_string().replace(' ', "") == words
        }
        _ => false,
    })
}

/// The names that a tree of a `use` brings in, under the path before it.
pub(crate) fn read_use(
    tree: &[TokenTree],
    before: &[String],
    public: bool,
    imports: &mut Vec<Import>,
) {
    let mut path = before.to_vec();
    let mut name = None;
    let mut tokens = tree.iter();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Ident(word) if word == "as" => {
                name = tokens.next().map(TokenTree::to_string);
            }
            TokenTree::Ident(word) => path.push(word.to_string()),
            TokenTree::Group(group) => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                for branch in inner.split(|token| token.to_string() == ",") {
                    read_use(branch, &path, public, imports);
                }
                return;
            }
            TokenTree::Punct(sign) if sign.as_char() == '*' => name = Some("*".to_owned()),
            _ => {}
        }
    }
    // `{self}` is the module itself.
    if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
        path.pop();
    }
    if let Some(name) = name.or_else(|| path.last().cloned()) {
        imports.push(Import { name, path, public });
    }
}

/// All names and paths in code, groups included; a `use` in a function counts as one of the module.
fn read_paths(tokens: TokenStream, module: &mut Module) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut i = 0;
    while i < tokens.len() {
        match &tokens[i] {
            TokenTree::Ident(word) if word == "use" => {
                let end = tokens[i..]
                    .iter()
                    .position(|token| token.to_string() == ";");
                let end = end.map_or(tokens.len(), |end| i + end);
                read_use(&tokens[i + 1..end], &[], false, &mut module.imports);
                i = end;
            }
            TokenTree::Ident(word) => {
                let mut path = vec![word.to_string()];
                while let [colon, second, TokenTree::Ident(next), ..] = &tokens[i + 1..]
                    && colon.to_string() == ":"
                    && second.to_string() == ":"
                {
                    path.push(next.to_string());
                    i += 3;
                }
                module.paths.push(path);
            }
            TokenTree::Group(group) => read_paths(group.stream(), module),
            _ => {}
        }
        i += 1;
    }
}
