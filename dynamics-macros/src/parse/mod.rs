//! Tokens to a syntax tree.
//!
//! Reading goes on behind every error: it skips to the next comma or to the next
//! `name:`, so that an error in one cell hides no error in another.

mod cursor;
mod entry;
mod expression;
mod inertia;
mod list;
mod number;
mod row;
mod structure;
mod vector;

use proc_macro2::{Delimiter, Span, TokenStream};
use quote::quote;

use crate::diagnose::Diagnostics;
use crate::syntax::Call;
use cursor::Cursor;

/// Reads a call of the macro: the struct item, then the entries of the table.
///
/// In front of them `@[path]` may name the runtime crate, which the `macro_rules!`
/// front of that crate writes as `@[$crate]`.
pub(crate) fn call(input: TokenStream, diagnostics: &Diagnostics) -> Call {
    let mut cursor = Cursor::new(input, Span::call_site(), diagnostics);
    let path = path(&mut cursor);
    let structure = structure::structure(&mut cursor);
    if structure
        .as_ref()
        .is_none_or(|structure| !structure.complete)
    {
        entry::skip_to_entry(&mut cursor);
    }
    let table = cursor.rest();
    Call {
        path,
        structure,
        entries: entry::entries(&mut cursor),
        table,
    }
}

fn path(cursor: &mut Cursor) -> TokenStream {
    if cursor.take_char('@').is_some()
        && let Some(group) = cursor.take_group(Delimiter::Bracket)
    {
        return group.stream();
    }
    quote!(::dynamics_runtime)
}
