//! Tokens to a tree.
//!
//! Reading goes on behind every error: it skips to the next comma or to the next
//! `name:`. An error in one cell hides no error in another.

mod assigned;
mod cursor;
mod entry;
pub(crate) mod expression;
#[cfg(feature = "files")]
mod formula;
mod list;
pub(crate) mod number;
mod row;
mod size;
mod structure;
#[cfg(feature = "files")]
pub(crate) mod text;
mod value;

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use quote::quote;
use syn::buffer::TokenBuffer;

use crate::call::{Call, Structure};
use crate::description::{Entry, Name, Table};
use crate::diagnose::Diagnostics;
use crate::tree::Node;
use cursor::Cursor;

/// Reads a call of the macro: the struct item, then the entries of the table, as a tree of which nothing is
/// known yet. A call that is too long to be read has no tree.
///
/// In front of them `@[path]` may name the runtime crate, which the `macro_rules!`
/// front of that crate writes as `@[$crate]`.
pub(crate) fn call(input: TokenStream, diagnostics: &Diagnostics) -> (Call, Option<Node>) {
    if let Err((readable, _)) = size::check(&input, diagnostics) {
        return (refused(input.into_iter().take(readable).collect()), None);
    }
    let tokens = TokenBuffer::new2(input);
    // The mistakes of the entries stand in their tree.
    let of_entries = Diagnostics::new();
    let mut cursor = Cursor::new(&tokens, Span::call_site(), diagnostics);
    let mut call = head(&mut cursor);
    if !call.table.has_all_fields {
        entry::skip_to_entry(&mut cursor);
    }
    // Names are looked for where a field may be unused.
    if !call.table.fields.is_empty() {
        call.table.mentions = names(cursor.rest());
    }
    let root = entry::entries(&mut cursor.reporting_to(&of_entries));
    (call, Some(root))
}

/// A call that is too long to be read, as far as its start tells what the user's code knows of it.
fn refused(start: TokenStream) -> Call {
    let unread = Diagnostics::new();
    let tokens = TokenBuffer::new2(start);
    let mut call = head(&mut Cursor::new(&tokens, Span::call_site(), &unread));
    call.is_refused = true;
    call.table.entries.push(Entry::Functions(None));
    if !unread.is_empty() {
        call.structure = None;
    }
    unread.forget();
    call
}

/// Reads what stands in front of the entries.
fn head(cursor: &mut Cursor) -> Call {
    let path = path(cursor);
    let structure = structure::structure(cursor);
    Call {
        table: table(structure.as_ref()),
        structure,
        ..Call::new(path)
    }
}

/// The parts of a table that the struct says.
fn table(structure: Option<&Structure>) -> Table {
    let fields = structure.iter().flat_map(|structure| &structure.fields);
    Table {
        name: structure.map(|structure| Name::from(&structure.name)),
        fields: fields
            .filter_map(|field| field.name.as_ref().map(Name::from))
            .collect(),
        has_all_fields: structure.is_some_and(|structure| structure.complete),
        ..Table::default()
    }
}

/// The identifiers, at whatever depth.
pub(crate) fn names(tokens: TokenStream) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    let mut streams = vec![tokens];
    while let Some(stream) = streams.pop() {
        for token in stream {
            match token {
                TokenTree::Ident(ident) => {
                    names.insert(Name::from(&ident).plain().to_owned());
                }
                TokenTree::Group(group) => streams.push(group.stream()),
                _ => {}
            }
        }
    }
    names
}

impl From<&Ident> for Name {
    fn from(ident: &Ident) -> Name {
        Name::new(ident.to_string(), ident.into())
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
