//! The entries about a file: `file`, `chain`, `ignore`.

use proc_macro2::{Delimiter, TokenTree};
use syn::Lit;

use super::cursor::Cursor;
use super::list::comma_separated;
use crate::description::{FileName, Name};
use crate::diagnose::Reported;
use crate::mistake::expected;

/// Reads `"robots/arm.urdf"`.
pub(super) fn name(cursor: &mut Cursor) -> Result<FileName, Reported> {
    let place = cursor.here();
    match take_text(cursor) {
        Some(path) => Ok(FileName { path, place }),
        None => Err(cursor.expected(expected::file_name())),
    }
}

/// Reads `["base_link", "tool0"]`.
pub(super) fn chain(cursor: &mut Cursor) -> Result<[Name; 2], Reported> {
    let group = cursor.take_list(Delimiter::Bracket, expected::chain())?;
    let names = names(&mut cursor.inside(&group), expected::chain)?;
    let place = group.span();
    names
        .try_into()
        .map_err(|_| cursor.error(place, crate::mistake::file::two_links()))
}

/// Reads `[finger_1, "finger-2"]`, or `rest`.
pub(super) fn ignored(cursor: &mut Cursor) -> Result<Vec<Name>, Reported> {
    if let Some(rest) = cursor.take_word("rest") {
        return Ok(vec![Name::from(&rest)]);
    }
    let group = cursor.take_list(Delimiter::Bracket, expected::ignored())?;
    names(&mut cursor.inside(&group), expected::ignored_joint)
}

fn names(
    cursor: &mut Cursor,
    what: impl Fn() -> expected::Expected,
) -> Result<Vec<Name>, Reported> {
    let mut names = Vec::new();
    comma_separated(cursor, at_name, |cursor| match take_name(cursor) {
        Some(name) => {
            let label = format!("`{name}`");
            names.push(name);
            Ok(label)
        }
        None => Err(no_name(cursor, what())),
    })?;
    Ok(names)
}

/// Reports that no name comes next; of a number, that it stands in quotes where it is one.
pub(super) fn no_name(cursor: &Cursor, what: expected::Expected) -> Reported {
    match cursor.peek() {
        Some(TokenTree::Literal(number)) => {
            let number = number.to_string();
            cursor.error(cursor.here(), crate::mistake::file::number_as_name(&number))
        }
        _ => cursor.expected(what),
    }
}

/// Whether a name comes next, be it in quotes.
pub(super) fn at_name(cursor: &Cursor) -> bool {
    cursor.peek_ident().is_some() || text(cursor).is_some()
}

/// Takes a name: names in files may have other letters than those of Rust, then it stands in quotes.
pub(super) fn take_name(cursor: &mut Cursor) -> Option<Name> {
    let place = cursor.here();
    match cursor.take_ident() {
        Some(ident) => Some(Name::from(&ident)),
        None => take_text(cursor).map(|text| Name::new(text, place)),
    }
}

fn take_text(cursor: &mut Cursor) -> Option<String> {
    let text = text(cursor)?;
    cursor.take();
    Some(text)
}

/// The next token where it is a string.
fn text(cursor: &Cursor) -> Option<String> {
    match cursor.peek()? {
        TokenTree::Literal(literal) => match Lit::new(literal) {
            Lit::Str(text) => Some(text.value()),
            _ => None,
        },
        _ => None,
    }
}
