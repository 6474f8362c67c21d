//! Lists of names with something behind them: `lock: [joint = value, ...]`, `functions: [name = (function, ...), ...]`,
//! `joints: { joint: { ... }, ... }` beside a file.

use proc_macro2::{Delimiter, TokenTree};

use super::cursor::Cursor;
use super::list::{colon, comma_separated};
use super::structure::name;
use super::value::{absent, list, pair, stray, value};
use crate::description::Name;
use crate::mistake::expected::{self, Expected};
use crate::mistake::{Mistake, entry, file};
use crate::tree::{Key, Kind, Node};

/// Reads `[joint = value, ...]`, a table of joints that are locked, or of followers.
pub(super) fn joints(cursor: &mut Cursor, are_followers: bool) -> Node {
    let start = absent(cursor);
    let errors = cursor.errors();
    let group = cursor.take_list(Delimiter::Bracket, expected::joints(are_followers));
    let faults = cursor.take_errors(errors);
    let Ok(group) = group else {
        return Node { faults, ..start };
    };
    let items = comma_separated(cursor.inside(&group), at_name, |cursor| {
        let Some(name) = take_name(cursor) else {
            let faults = vec![(
                cursor.here(),
                no_name(cursor, expected::named_joint(are_followers)),
            )];
            return (stray(cursor, faults), String::new());
        };
        let sign = cursor.here();
        let node = if cursor.take_char('=').is_some() {
            value(cursor)
        } else {
            if cursor.take_char(':').is_some() {
                cursor.error(sign, entry::joint_by_colon(&name, are_followers));
            } else {
                cursor.expected(expected::value_after(&name, are_followers));
            }
            absent(cursor)
        };
        let key = Key::new(name.to_string(), (&name).into());
        ((key, node), format!("`{name} = ...`"))
    });
    Node {
        kind: Kind::Table(items),
        faults,
        ..start
    }
}

/// The mistake of what is no name; of a number, that it stands in quotes where it is one.
fn no_name(cursor: &Cursor, what: Expected) -> Mistake {
    match cursor.peek() {
        Some(TokenTree::Literal(number)) => file::number_as_name(&number.to_string()),
        _ => crate::mistake::instead(&what, cursor.found().as_deref()),
    }
}

/// Whether a name comes next, be it in quotes.
fn at_name(cursor: &Cursor) -> bool {
    take_name(&mut cursor.clone()).is_some()
}

/// Takes a name: names in files may have other letters than those of Rust, then it stands in quotes.
fn take_name(cursor: &mut Cursor) -> Option<Name> {
    let place = cursor.here();
    match cursor.take_ident() {
        Some(ident) => Some(Name::from(&ident)),
        None => cursor.take_text().map(|text| Name::new(text, place)),
    }
}

/// Whether joints of a file with their cells come next, `{ joint: { ... } }`, and no row in braces.
pub(super) fn at_cells(cursor: &Cursor) -> bool {
    let mut ahead = cursor.clone();
    let Some(group) = ahead.take_group(Delimiter::Brace) else {
        return false;
    };
    let mut inside = ahead.inside(&group);
    let has_name = inside.take_ident().is_some();
    let is_typed = inside.take_char(':').is_none() || inside.peek_ident().is_some();
    !(has_name && is_typed)
}

/// Reads `{ joint: { friction: { ... } }, "joint 2": { motor: { ... } } }`, or another table of tables with names, of
/// which `item` is one.
pub(super) fn named_tables(cursor: &mut Cursor, item: fn() -> Expected) -> Node {
    let start = absent(cursor);
    let Some(group) = cursor.take_group(Delimiter::Brace) else {
        return value(cursor);
    };
    let items = comma_separated(cursor.inside(&group), at_table, |cursor| {
        let Some(name) = take_name(cursor) else {
            let faults = vec![(cursor.here(), no_name(cursor, item()))];
            return (stray(cursor, faults), String::new());
        };
        let node = match colon(cursor, name.plain()) {
            Ok(()) => value(cursor),
            Err(_) => absent(cursor),
        };
        let key = Key::new(name.to_string(), (&name).into());
        ((key, node), format!("`{name}`"))
    });
    Node {
        kind: Kind::Table(items),
        ..start
    }
}

/// Whether `name:` comes next, the name perhaps in quotes.
fn at_table(cursor: &Cursor) -> bool {
    let mut ahead = cursor.clone();
    take_name(&mut ahead).is_some() && ahead.at(':')
}

/// Reads `[jacobian, control_terms = (mass_matrix, gravity_vector)]`.
pub(super) fn functions(cursor: &mut Cursor) -> Node {
    let start = absent(cursor);
    let Some(group) = cursor.take_group(Delimiter::Bracket) else {
        return value(cursor);
    };
    let at_item = |cursor: &Cursor| cursor.peek_ident().is_some();
    let items = comma_separated(cursor.inside(&group), at_item, |cursor| {
        if let Some(TokenTree::Group(group)) = cursor.peek()
            && group.delimiter() == Delimiter::Parenthesis
        {
            let shown = cursor.shown_until(&[',', ';']);
            cursor.error(cursor.here(), entry::tuple_without_name(&shown));
            return (absent(cursor), String::new());
        }
        if cursor.at_name_before('=') || cursor.at_key() {
            return fused(cursor);
        }
        let node = value(cursor);
        let what = match &node.kind {
            Kind::Applied(name, ..) => format!("`{name}(...)`"),
            _ => format!("`{}`", node.word().unwrap_or_default()),
        };
        (node, what)
    });
    Node {
        kind: Kind::List(items),
        ..start
    }
}

/// Reads `name = (mass_matrix, gravity_vector)`.
fn fused(cursor: &mut Cursor) -> (Node, String) {
    let Ok(name) = name(cursor, expected::name_of_tuple()) else {
        return (absent(cursor), String::new());
    };
    let sign = cursor.here();
    if cursor.take_char(':').is_some() {
        cursor.error(sign, entry::tuple_by_colon(&name));
    }
    let node = pair(cursor, &name, |cursor| {
        let (start, errors) = (absent(cursor), cursor.errors());
        let group = cursor.take_list(Delimiter::Parenthesis, expected::parts_of(&name));
        let faults = cursor.take_errors(errors);
        let kind = group.map_or(Kind::Absent, |group| {
            Kind::List(list(cursor.inside(&group)))
        });
        Node {
            kind,
            faults,
            ..start
        }
    });
    (node, format!("`{name} = (...)`"))
}
