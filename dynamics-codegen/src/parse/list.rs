//! Items between commas.

use proc_macro2::TokenTree;

use super::cursor::Cursor;
use crate::diagnose::Reported;
use crate::mistake::{self, expected};
use crate::place::Place;
use crate::tree::{Key, Node};

// An item is a value, alone or with its key.
impl AsMut<Node> for Node {
    fn as_mut(&mut self) -> &mut Node {
        self
    }
}

impl AsMut<Node> for (Key, Node) {
    fn as_mut(&mut self) -> &mut Node {
        &mut self.1
    }
}

/// Reads items between commas, a comma after the last one allowed. `item` returns
/// what it read and how a message names it; `at_item` tells whether an item starts here.
pub(super) fn comma_separated<'t, T: AsMut<Node>>(
    mut cursor: Cursor<'t>,
    at_item: impl Fn(&Cursor<'t>) -> bool,
    mut item: impl FnMut(&mut Cursor<'t>) -> (T, String),
) -> Vec<T> {
    let mut items = Vec::new();
    while !cursor.at_end() {
        let item = one(&mut cursor, &at_item, |cursor| {
            let (item, what) = item(cursor);
            (item, ',', what)
        });
        items.push(item);
    }
    items
}

/// Reads an item, its documentation in front and its separator behind. Where the end of the item
/// is not known, reading goes on at the next one.
pub(super) fn one<'t, T: AsMut<Node>>(
    cursor: &mut Cursor<'t>,
    at_item: impl Fn(&Cursor<'t>) -> bool,
    item: impl FnOnce(&mut Cursor<'t>) -> (T, char, String),
) -> T {
    let (start, errors) = (cursor.taken, cursor.errors());
    skip_docs(cursor);
    let (mut item, separator, what) = item(cursor);
    let node = item.as_mut();
    node.faults.splice(0..0, cursor.take_errors(errors));
    if node.has_end() {
        end_item(cursor, separator, &what, at_item);
        node.behind = cursor.take_errors(errors);
    } else {
        cursor.recover(start);
    }
    item
}

/// Takes the separator behind an item, or reports that it is missing and goes on
/// where the next item starts.
fn end_item<'t>(
    cursor: &mut Cursor<'t>,
    separator: char,
    what: &str,
    at_item: impl Fn(&Cursor<'t>) -> bool,
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
        cursor.recover(cursor.taken);
    }
}

/// Skips doc comments; other attributes are refused.
fn skip_docs(cursor: &mut Cursor) {
    while let Some(hash) = cursor.take_char('#') {
        let Some(group) = cursor.take_group(proc_macro2::Delimiter::Bracket) else {
            cursor.error(hash, mistake::lonely_hash());
            return;
        };
        if !cursor.inside(&group).at_word("doc") {
            let place = Place::from(hash).to(group.span);
            cursor.error(place, mistake::attribute());
        }
    }
}

/// Takes the `:` behind a name. Where it is missing and a value follows all the same,
/// the error is reported and reading goes on.
pub(super) fn colon(cursor: &mut Cursor, name: &str) -> Result<(), Reported> {
    if !cursor.at_path_separator() && cursor.take_char(':').is_some() {
        return Ok(());
    }
    let reported = cursor.expected(expected::colon_after(&name));
    let instead = if cursor.at_path_separator() {
        cursor.take().and(cursor.take()).is_some()
    } else {
        cursor.take_char('=').is_some()
    };
    let at_next_item = !instead && cursor.at_key();
    match cursor.peek() {
        Some(TokenTree::Punct(punct)) if punct.as_char() != '-' => Err(reported),
        Some(_) if !at_next_item => Ok(()),
        _ => Err(reported),
    }
}
