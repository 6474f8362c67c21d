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
mod size;
mod structure;
mod unknown;
mod vector;

use proc_macro2::{Delimiter, Span, TokenStream};
use quote::quote;
use syn::buffer::TokenBuffer;

use crate::diagnose::Diagnostics;
use crate::syntax::{Call, Entry};
use cursor::Cursor;

/// Reads a call of the macro: the struct item, then the entries of the table.
///
/// In front of them `@[path]` may name the runtime crate, which the `macro_rules!`
/// front of that crate writes as `@[$crate]`.
pub(crate) fn call(input: TokenStream, diagnostics: &Diagnostics) -> Call {
    if let Err((readable, _)) = size::check(&input, diagnostics) {
        return refused(input.into_iter().take(readable).collect());
    }
    let tokens = TokenBuffer::new2(input);
    let mut cursor = Cursor::new(&tokens, Span::call_site(), diagnostics);
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
        is_refused: false,
    }
}

/// A call that is too long to be read, as far as its start tells what the user's code knows of it.
fn refused(start: TokenStream) -> Call {
    let unread = Diagnostics::new();
    let tokens = TokenBuffer::new2(start);
    let mut cursor = Cursor::new(&tokens, Span::call_site(), &unread);
    let path = path(&mut cursor);
    let structure = structure::structure(&mut cursor);
    let is_good = unread.is_empty();
    unread.forget();
    Call {
        path,
        structure: structure.filter(|_| is_good),
        entries: vec![Entry::Functions(None)],
        table: TokenStream::new(),
        is_refused: true,
    }
}

fn path(cursor: &mut Cursor) -> TokenStream {
    if cursor.take_char('@').is_some()
        && let Some(group) = cursor.take_group(Delimiter::Bracket)
    {
        return cursor.inside(&group).rest();
    }
    quote!(::dynamics_runtime)
}
