//! Lists between commas, and the `key: value` items in them.

use proc_macro2::{Delimiter, Ident, TokenTree};

use super::cursor::Cursor;
use super::unknown::Wrong;
use crate::description::Given;
use crate::diagnose::Reported;
use crate::mistake::{self, expected};
use crate::place::Place;

/// Reads items between commas, a comma after the last one allowed. `item` returns
/// how a message names what it read; `at_item` tells whether an item starts here. The
/// error is that of an item that could not be read; reading went on behind it.
pub(super) fn comma_separated<'d>(
    cursor: &mut Cursor<'d>,
    at_item: impl Fn(&Cursor<'d>) -> bool,
    mut item: impl FnMut(&mut Cursor<'d>) -> Result<String, Reported>,
) -> Result<(), Reported> {
    let mut outcome = Ok(());
    while !cursor.at_end() {
        let start = cursor.taken();
        match skip_docs(cursor).and_then(|()| item(cursor)) {
            Ok(what) => end_item(cursor, ',', &what, &at_item),
            Err(reported) => {
                outcome = Err(reported);
                cursor.recover(start);
            }
        }
    }
    outcome
}

/// Takes the separator behind an item, or reports that it is missing and goes on
/// where the next item starts.
pub(super) fn end_item<'d>(
    cursor: &mut Cursor<'d>,
    separator: char,
    what: &str,
    at_item: impl Fn(&Cursor<'d>) -> bool,
) {
    cursor.take_decimal_comma(&at_item);
    if cursor.take_char(separator).is_some() || (separator == ',' && cursor.at_end()) {
        return;
    }
    cursor.expected(expected::separator(separator, what));
    if cursor.take_char(',').is_some() || cursor.take_char(';').is_some() {
        return;
    }
    if !at_item(cursor) {
        cursor.recover(cursor.taken());
    }
}

/// Skips doc comments; other attributes are refused.
pub(super) fn skip_docs(cursor: &mut Cursor) -> Result<(), Reported> {
    while let Some(hash) = cursor.take_char('#') {
        let Some(group) = cursor.take_group(Delimiter::Bracket) else {
            return Err(cursor.error(hash, mistake::lonely_hash()));
        };
        if !cursor.inside(&group).at_word("doc") {
            let place = Place::from(hash).to(group.span());
            cursor.error(place, mistake::attribute());
        }
    }
    Ok(())
}

/// The key of an item.
pub(super) struct Key {
    /// As written.
    pub(super) ident: Ident,
    /// As meant.
    pub(super) name: &'static str,
    /// The error where the two differ.
    slip: Option<Reported>,
}

impl Key {
    /// Reports that there was one already, unless this one was reported before.
    pub(super) fn twice(&self, cursor: &Cursor) -> Reported {
        let ident = &self.ident;
        self.slip
            .unwrap_or_else(|| cursor.error(ident, mistake::given_twice(&ident.to_string())))
    }
}

/// Reads a key, one of `known`. For another word `wrong` says what to report and which
/// key was meant: then the value is still read.
pub(super) fn key(
    cursor: &mut Cursor,
    what: &str,
    known: &[&'static str],
    wrong: impl Fn(&str) -> Wrong,
) -> Result<Key, Reported> {
    let Some(ident) = cursor.take_ident() else {
        return Err(cursor.expected(expected::key(what, known)));
    };
    let word = ident.to_string();
    let (name, slip) = match known.iter().find(|right| **right == word) {
        Some(name) => (*name, None),
        None => {
            let wrong = wrong(&word);
            let reported = cursor.error(&ident, wrong.mistake);
            match wrong.meant {
                // That one stands further on.
                Some(name) if has_key(cursor, name) => return Err(reported),
                Some(name) => (name, Some(reported)),
                None => return Err(reported),
            }
        }
    };
    Ok(Key { ident, name, slip })
}

/// Takes the `:` behind a name. Where it is missing and a value follows all the same,
/// the error is reported and reading goes on.
pub(super) fn colon(cursor: &mut Cursor, name: &str) -> Result<(), Reported> {
    if !cursor.at_path_separator() && cursor.take_char(':').is_some() {
        return Ok(());
    }
    let reported = cursor.expected(expected::colon_after(&name));
    let instead = match cursor.at_path_separator() {
        true => cursor.take().and(cursor.take()).is_some(),
        false => cursor.take_char('=').is_some(),
    };
    let at_next_item = !instead && cursor.at_key();
    match cursor.peek() {
        Some(TokenTree::Punct(punct)) if punct.as_char() != '-' => Err(reported),
        Some(_) if !at_next_item => Ok(()),
        _ => Err(reported),
    }
}

/// Whether a key stands behind one of the commas that follow.
fn has_key(cursor: &Cursor, name: &str) -> bool {
    let tokens: Vec<String> = cursor
        .rest()
        .into_iter()
        .map(|token| token.to_string())
        .collect();
    tokens.windows(3).any(|three| three == [",", name, ":"])
}

/// Reads `: value` into a slot, unless it was filled before.
pub(super) fn fill<T>(
    cursor: &mut Cursor,
    slot: &mut Given<T>,
    key: Key,
    read: impl FnOnce(&mut Cursor) -> Result<T, Reported>,
) -> Result<(), Reported> {
    if !slot.is_absent() {
        return Err(key.twice(cursor));
    }
    *slot = Given::Unreadable;
    colon(cursor, &key.ident.to_string())?;
    *slot = Given::As(read(cursor)?);
    Ok(())
}
