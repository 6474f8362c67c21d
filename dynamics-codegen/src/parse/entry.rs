//! The entries of a call: `key: value,` and `let name = value;`.

use proc_macro2::{Delimiter, Ident};

use super::assigned::{at_cells, functions, joints, named_tables};
use super::cursor::Cursor;
use super::list::one;
use super::row::rows;
use super::value::{absent, base, keyed, stray, value};
use crate::keys::KEYS;
use crate::mistake::{self, expected};
use crate::tree::{Fault, Key, KeyKind, Kind, Node};
use crate::words;

/// Reads all entries, as a table.
pub(super) fn entries(cursor: &mut Cursor) -> Node {
    let start = absent(cursor);
    let mut entries = Vec::new();
    let mut faults = Vec::new();
    while !cursor.at_end() {
        if at_struct(cursor) {
            faults.push(second_struct(cursor));
            break;
        }
        entries.push(one(cursor, at_entry, entry));
    }
    Node {
        kind: Kind::Table(entries),
        faults,
        ..start
    }
}

/// Reads an entry. Returns the separator behind it, and how a message names it.
fn entry(cursor: &mut Cursor) -> ((Key, Node), char, String) {
    let binding = if cursor.take_word("let").is_some() {
        binding(cursor)
    } else if at_constant(cursor) {
        constant(cursor)
    } else if at_bare_binding(cursor) {
        cursor.expected(expected::let_in_front());
        binding(cursor)
    } else {
        let (key, node) = keyed(cursor, value_of);
        let what = format!("`{}`", key.word);
        return ((key, node), ',', what);
    };
    let what = format!("`let {} = ...`", binding.0.word);
    (binding, ';', what)
}

/// Reads the value of that key.
fn value_of(cursor: &mut Cursor, key: &str) -> Node {
    match words::meant(key, KEYS).unwrap_or(key) {
        "base" => base(cursor),
        // In brackets `links` are the rows of a table, in another program's words.
        "joints" => rows(cursor),
        "links" if !at_cells(cursor) => rows(cursor),
        "frames" => named_tables(cursor, expected::frame),
        "links" => named_tables(cursor, expected::link_of_file),
        "functions" => functions(cursor),
        "lock" => joints(cursor, false),
        "couple" => joints(cursor, true),
        _ => value(cursor),
    }
}

/// Whether another struct comes next.
fn at_struct(cursor: &Cursor) -> bool {
    let mut cursor = cursor.clone();
    while cursor.take_char('#').is_some() && cursor.take_group(Delimiter::Bracket).is_some() {}
    ["pub", "struct"].iter().any(|word| cursor.at_word(word)) && !cursor.at_key()
}

/// Skips another struct with its table, which is a mistake.
fn second_struct(cursor: &mut Cursor) -> Fault {
    while cursor.take_char('#').is_some() {
        cursor.take();
    }
    let fault = (cursor.here(), mistake::structure::second());
    while cursor.take().is_some() {}
    fault
}

/// Skips what stands in front of the first entry.
pub(super) fn skip_to_entry(cursor: &mut Cursor) {
    while !cursor.at_end() && !at_entry(cursor) {
        cursor.take();
    }
}

/// Whether `name = ` comes next, where the name is not one of the keys.
fn at_bare_binding(cursor: &Cursor) -> bool {
    let is_key = |word: Ident| words::nearest(&word.to_string(), KEYS).is_some();
    cursor.at_name_before('=') && !cursor.peek_ident().is_some_and(is_key)
}

/// Whether a Rust constant comes next.
fn at_constant(cursor: &Cursor) -> bool {
    let is_constant = |word: Ident| word == "const" || word == "static";
    cursor.peek_ident().is_some_and(is_constant) && !cursor.at_key()
}

fn at_entry(cursor: &Cursor) -> bool {
    cursor.at_key() || cursor.at_word("let") || at_constant(cursor)
}

/// Reads `const NAME: type = value`, which is refused, as the `let` that was meant.
fn constant(cursor: &mut Cursor) -> (Key, Node) {
    let start = cursor.here();
    cursor.take();
    cursor.take_word("mut");
    let Some(name) = cursor.take_ident() else {
        cursor.expected(expected::name_of_constant());
        return stray(cursor, Vec::new());
    };
    let place = start.to(&name);
    if cursor.at(':') {
        cursor.take_until(&['=', ';', ',']);
    }
    let has_value = cursor.take_char('=').is_some();
    let shown = has_value.then(|| cursor.shown_until(&[';', ',']));
    cursor.error(place, mistake::value::constant(&name, shown.as_deref()));
    bound(cursor, &name, has_value)
}

/// The binding of a name to the value that comes next, where there is one.
fn bound(cursor: &mut Cursor, name: &Ident, has_value: bool) -> (Key, Node) {
    let key = Key {
        kind: KeyKind::Let,
        ..Key::from(name)
    };
    let node = if has_value {
        value(cursor)
    } else {
        absent(cursor)
    };
    (key, node)
}

/// Reads `name = value`, behind `let`.
fn binding(cursor: &mut Cursor) -> (Key, Node) {
    if let Some(word) = cursor.take_word("mut") {
        cursor.error(&word, mistake::value::let_mut());
    }
    let Some(name) = cursor.take_ident() else {
        cursor.expected(expected::name_after_let());
        return stray(cursor, Vec::new());
    };
    let has_value = cursor.take_char('=').is_some();
    if !has_value {
        cursor.expected(expected::equals_after_let(&name));
    }
    bound(cursor, &name, has_value)
}
