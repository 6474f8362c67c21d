//! Values, whatever they mean: words, expressions, lists and tables.

use proc_macro2::{Delimiter, Ident};

use super::cursor::Cursor;
use super::expression::{at_value, ends_word, expression, function};
use super::list::{colon, comma_separated};
use crate::description::{Name, Share};
use crate::tree::{Fault, Found, Key, KeyKind, Kind, Node};

/// Reads a value.
pub(super) fn value(cursor: &mut Cursor) -> Node {
    let start = absent(cursor);
    let kind = kind(cursor);
    Node { kind, ..start }
}

/// Reads `{ ... }`, or a word and `{ ... }` behind it.
pub(super) fn base(cursor: &mut Cursor) -> Node {
    let (start, mut behind) = (absent(cursor), cursor.clone());
    let Some(word) = behind.take_ident() else {
        return value(cursor);
    };
    let cells = absent(&behind);
    let Some(group) = behind.take_group(Delimiter::Brace) else {
        return value(cursor);
    };
    let kind = Kind::Table(table(behind.inside(&group), ""));
    let cells = Box::new(Node { kind, ..cells });
    *cursor = behind;
    let kind = Kind::Applied(Name::from(&word), cells, Vec::new());
    Node { kind, ..start }
}

/// The node of a value that is not there: something else is, or nothing.
pub(super) fn absent(cursor: &Cursor) -> Node {
    let (place, found) = cursor.start();
    Node::found(place, found, Kind::Absent)
}

fn kind(cursor: &mut Cursor) -> Kind {
    if let Some(group) = cursor.take_group(Delimiter::Brace) {
        return Kind::Table(table(cursor.inside(&group), ""));
    }
    if let Some(group) = cursor.take_group(Delimiter::Bracket) {
        return Kind::List(list(cursor.inside(&group)));
    }
    let mut behind = cursor.clone();
    if let Some(word) = behind.take_ident() {
        let is_function = function(&word.to_string()).is_some();
        if !is_function && let Some(arguments) = arguments(&mut behind) {
            let errors = cursor.errors();
            let _ = expression(&mut cursor.clone());
            let faults = cursor.take_errors(errors);
            *cursor = behind;
            return Kind::Applied(Name::from(&word), Box::new(arguments), faults);
        }
        if ends_word(&behind) {
            *cursor = behind;
            return Kind::Word(Name::from(&word));
        }
    }
    number(cursor)
}

/// An expression, a share or a text.
fn number(cursor: &mut Cursor) -> Kind {
    let errors = cursor.errors();
    let mut start = cursor.clone();
    match expression(cursor) {
        Ok((value, None)) => Kind::Value(value),
        Ok((number, Some(sign))) => Kind::Share(Share {
            place: number.place.to(sign),
            number,
            percent: true,
        }),
        Err(_) => {
            let faults = cursor.take_errors(errors);
            let Some(text) = start.take_text() else {
                return Kind::Unreadable(faults);
            };
            *cursor = start;
            Kind::Text(text)
        }
    }
}

/// Takes what stands between delimiters behind a name: values where these are parentheses.
fn arguments(cursor: &mut Cursor) -> Option<Node> {
    if cursor.at_fragment() {
        return None;
    }
    let before = cursor.clone();
    let kind = match cursor.take_group(Delimiter::Parenthesis) {
        Some(group) => Kind::List(list(cursor.inside(&group))),
        None => cursor.take_any_group().map(|_| Kind::Absent)?,
    };
    Some(Node {
        kind,
        ..absent(&before)
    })
}

/// Reads values between commas.
pub(super) fn list(cursor: Cursor) -> Vec<Node> {
    comma_separated(cursor, at_value, |cursor| {
        if cursor.at_name_before('=')
            && let Some(name) = cursor.take_ident()
        {
            let what = format!("`{name}`");
            return (pair(cursor, &name, value), what);
        }
        let node = value(cursor);
        let what = match &node.kind {
            Kind::Word(name) => format!("`{name}`"),
            Kind::Text(text) => format!("`{text}`"),
            Kind::Applied(name, ..) => format!("`{name}(...)`"),
            _ => "this value".to_owned(),
        };
        (node, what)
    })
}

/// Reads ` = value` behind a name.
pub(super) fn pair<'t>(
    cursor: &mut Cursor<'t>,
    name: &Ident,
    read: impl FnOnce(&mut Cursor<'t>) -> Node,
) -> Node {
    cursor.take_char('=');
    let kind = Kind::Pair(Key::from(name), Box::new(read(cursor)));
    Node::found(name.into(), Found::Token(name.clone().into()), kind)
}

/// Reads `key: value` items. A message calls each of them `kind` and its key.
pub(super) fn table(cursor: Cursor, kind: &str) -> Vec<(Key, Node)> {
    comma_separated(cursor, Cursor::at_key, |cursor| {
        let (key, node) = keyed(cursor, |cursor, _| value(cursor));
        let what = format!("{kind}`{}`", key.word);
        ((key, node), what)
    })
}

/// Reads `key: value`, by a reader that knows the key.
pub(super) fn keyed<'t>(
    cursor: &mut Cursor<'t>,
    read: impl FnOnce(&mut Cursor<'t>, &str) -> Node,
) -> (Key, Node) {
    let Some(ident) = cursor.take_ident() else {
        return stray(cursor, Vec::new());
    };
    let key = Key::from(&ident);
    let node = match colon(cursor, &key.word) {
        Ok(()) => read(cursor, &key.word),
        Err(_) => absent(cursor),
    };
    (key, node)
}

impl From<&Ident> for Key {
    fn from(ident: &Ident) -> Key {
        Key::new(ident.to_string(), ident.into())
    }
}

/// The item for tokens in place of a key and its value.
pub(super) fn stray(cursor: &Cursor, faults: Vec<Fault>) -> (Key, Node) {
    let key = Key {
        word: cursor.found().unwrap_or_default(),
        place: cursor.here(),
        kind: KeyKind::Stray,
    };
    let node = Node {
        faults,
        ..absent(cursor)
    };
    (key, node)
}
