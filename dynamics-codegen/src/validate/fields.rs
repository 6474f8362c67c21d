//! Fields that no value uses.

use std::collections::BTreeSet;

use proc_macro2::{TokenStream, TokenTree};

use super::plain;
use super::scope::Scope;
use crate::diagnose::Diagnostics;
use crate::mistake;
use crate::syntax::Structure;

/// Reports the fields that no value uses. Where there are errors, the value that uses
/// one may be unreadable: then only a field that the table never names is reported.
pub(super) fn report_unused(
    structure: &Structure,
    scope: &Scope,
    table: &TokenStream,
    diagnostics: &Diagnostics,
) {
    let named = match diagnostics.is_empty() {
        true => BTreeSet::new(),
        false => names(table),
    };
    let fields = structure.fields.iter().filter_map(|f| f.name.as_ref());
    for (index, name) in fields.enumerate() {
        let word = plain(name);
        let used = scope.is_used(index) || named.contains(&word);
        if !used {
            diagnostics.error(name, mistake::structure::unused_field(&word));
        }
    }
}

/// The identifiers, at whatever depth.
fn names(tokens: &TokenStream) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    let mut streams = vec![tokens.clone()];
    while let Some(stream) = streams.pop() {
        for token in stream {
            match token {
                TokenTree::Ident(ident) => {
                    names.insert(plain(&ident));
                }
                TokenTree::Group(group) => streams.push(group.stream()),
                _ => {}
            }
        }
    }
    names
}
