//! Fields that no value uses.

use proc_macro2::{TokenStream, TokenTree};

use super::plain;
use super::scope::Scope;
use crate::diagnose::Diagnostics;
use crate::syntax::Structure;

/// Reports the fields that no value uses. Where there are errors, the value that uses
/// one may be unreadable: then only a field that the table never names is reported.
pub(super) fn report_unused(
    structure: &Structure,
    scope: &Scope,
    table: &TokenStream,
    diagnostics: &Diagnostics,
) {
    let unreadable = !diagnostics.is_empty();
    let names = structure.fields.iter().filter_map(|f| f.name.as_ref());
    for (index, name) in names.enumerate() {
        let word = plain(name);
        let used = scope.is_used(index) || (unreadable && names_it(table, &word));
        if !used {
            diagnostics.error(name, format_args!("no value uses the field `{word}`"));
        }
    }
}

/// Whether the identifier occurs, at whatever depth.
fn names_it(tokens: &TokenStream, word: &str) -> bool {
    let mut streams = vec![tokens.clone()];
    while let Some(stream) = streams.pop() {
        for token in stream {
            match token {
                TokenTree::Ident(ident) if plain(&ident) == word => return true,
                TokenTree::Group(group) => streams.push(group.stream()),
                _ => {}
            }
        }
    }
    false
}
