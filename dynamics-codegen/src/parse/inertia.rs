//! The cell `inertia`: entries of a tensor, or a solid.

use proc_macro2::{Delimiter, Ident};

use super::cursor::{Cursor, Group};
use super::expression::expression;
use super::list::{comma_separated, fill, key};
use super::unknown::{Wrong, unknown};
use super::vector::values_and;
use crate::description::{Axis, Entries, Given, Inertia, InertiaKind, Solid, Tensor};
use crate::diagnose::Reported;
use crate::mistake::{self, expected};
use crate::place::Place;

/// The entries of a tensor, in the engine's order.
pub(crate) const ENTRIES: [&str; 6] = ["xx", "yy", "zz", "xy", "yz", "xz"];

/// What a message calls them.
const ENTRY: &str = "tensor entry";

/// The solids and their arguments.
const SOLIDS: [(&str, Solid, &[&str]); 4] = [
    ("cuboid", Solid::Cuboid, &["x", "y", "z"]),
    ("cylinder", Solid::Cylinder(Axis::Z), &["radius", "length"]),
    ("rod", Solid::Rod(Axis::X), &["length"]),
    ("sphere", Solid::Sphere, &["radius"]),
];

/// Reads `{ xx: ..., ... }` or `cuboid(x, y, z)` and the like.
pub(super) fn inertia(cursor: &mut Cursor) -> Result<Inertia, Reported> {
    if let Some(group) = cursor.take_group(Delimiter::Brace) {
        return Ok(Inertia {
            place: group.span().into(),
            kind: InertiaKind::Tensor(tensor(cursor, &group)),
        });
    }
    let mut ahead = cursor.clone();
    match ahead.take_ident() {
        // A name alone is a number: a moment about one axis, which the tensor has as one of its entries.
        Some(name) if ahead.take_group(Delimiter::Parenthesis).is_some() || is_solid(&name) => {
            cursor.take_ident();
            solid(cursor, &name)
        }
        _ => Err(cursor.expected(expected::inertia())),
    }
}

fn is_solid(name: &Ident) -> bool {
    SOLIDS.iter().any(|(solid, ..)| name == solid)
}

/// Reads `{ xx: ..., ... }` of a tensor about the origin of the frame.
pub(super) fn inertia_at_origin(cursor: &mut Cursor) -> Result<Tensor, Reported> {
    let group = cursor
        .take_group(Delimiter::Brace)
        .ok_or_else(|| cursor.expected(expected::inertia_at_origin()))?;
    Ok(Tensor {
        place: group.span().into(),
        entries: tensor(cursor, &group),
    })
}

fn tensor<'t>(cursor: &Cursor<'t>, group: &Group<'t>) -> Entries {
    let mut entries = Entries::default();
    let outcome = comma_separated(&mut cursor.inside(group), Cursor::at_key, |cursor| {
        let key = key(cursor, ENTRY, &ENTRIES, unknown_entry)?;
        let what = format!("`{}`", key.ident);
        let index = ENTRIES.iter().position(|entry| *entry == key.name);
        fill(cursor, &mut entries[index.unwrap_or(0)], key, expression)?;
        Ok(what)
    });
    if outcome.is_err() {
        entries.iter_mut().for_each(Given::doubt);
    }
    entries
}

/// The message for a word that is no entry: `Ixx` and the like, below the diagonal, or a
/// slip.
pub(crate) fn unknown_entry(word: &str) -> Wrong {
    let lower = word.to_lowercase();
    let axes = lower.trim_start_matches('i').trim_start_matches('_');
    if let Some(entry) = ENTRIES.iter().find(|entry| **entry == axes) {
        return Wrong {
            mistake: mistake::unknown(ENTRY, word, Some(entry), &ENTRIES),
            meant: Some(entry),
        };
    }
    let mirrored = |entry: &&&str| entry.chars().rev().eq(axes.chars());
    match ENTRIES.iter().find(mirrored) {
        Some(entry) => Wrong {
            mistake: mistake::joint::mirrored_entry(word, entry),
            meant: Some(entry),
        },
        None => unknown(ENTRY, word, &ENTRIES),
    }
}

fn solid(cursor: &mut Cursor, name: &Ident) -> Result<Inertia, Reported> {
    let word = name.to_string();
    let Some((right, solid, arguments)) = SOLIDS.iter().find(|(solid, ..)| *solid == word) else {
        let wrong = unknown("solid", &word, &SOLIDS.map(|(name, ..)| name));
        return Err(cursor.error(name, wrong.mistake));
    };
    let shown = format!("{right}({})", arguments.join(", "));
    let Some(group) = cursor.take_group(Delimiter::Parenthesis) else {
        return Err(cursor.expected(expected::solid(&shown)));
    };
    let place = Place::from(name).to(group.span());
    let mut solid = *solid;
    let values = values_and(cursor, &group, arguments.len(), &shown, |cursor| {
        let named = at_argument(cursor);
        named.then(|| argument(cursor, right, &mut solid))
    })?;
    Ok(Inertia {
        place,
        kind: InertiaKind::Solid(solid, values),
    })
}

/// Whether `name = ` comes next.
fn at_argument(cursor: &Cursor) -> bool {
    cursor.at_name_before('=')
}

/// Reads `axis = z`, the axis along which a solid lies.
fn argument(cursor: &mut Cursor, name: &str, solid: &mut Solid) -> Result<String, Reported> {
    let Some(word) = cursor.take_ident() else {
        return Err(cursor.expected(expected::axis()));
    };
    cursor.take_char('=');
    let along: fn(Axis) -> Solid = match solid {
        _ if word != "axis" => {
            let mistake = mistake::joint::named_size(name, &word);
            return Err(cursor.error(&word, mistake));
        }
        Solid::Cylinder(_) => Solid::Cylinder,
        Solid::Rod(_) => Solid::Rod,
        Solid::Cuboid | Solid::Sphere => {
            return Err(cursor.error(&word, mistake::joint::without_axis(name)));
        }
    };
    *solid = along(axis(cursor)?);
    Ok("`axis`".to_owned())
}

fn axis(cursor: &mut Cursor) -> Result<Axis, Reported> {
    let axis = match cursor.peek_ident() {
        Some(word) if word == "x" => Axis::X,
        Some(word) if word == "y" => Axis::Y,
        Some(word) if word == "z" => Axis::Z,
        _ => return Err(cursor.expected(expected::axis())),
    };
    cursor.take();
    Ok(axis)
}
