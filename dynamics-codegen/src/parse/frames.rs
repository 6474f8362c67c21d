//! The entries `base` and `tool`.

use super::allow::{self, allow};
use super::cursor::{Cursor, Group};
use super::expression::expression;
use super::inertia::{inertia, inertia_at_origin};
use super::list::{Key, comma_separated, fill, key};
use super::row::braces;
use super::unknown::unknown;
use super::vector::{angles, vector};
use crate::description::{Placement, Tool};
use crate::diagnose::Reported;
use crate::mistake::expected;

pub(crate) const BASE: [&str; 2] = ["xyz", "rpy"];
pub(crate) const TOOL: [&str; 7] = [
    "xyz",
    "rpy",
    "mass",
    "com",
    "inertia",
    "inertia_at_origin",
    "allow",
];

/// Reads `{ xyz: [x, y, z], rpy: [roll, pitch, yaw] }`.
pub(super) fn base(cursor: &mut Cursor) -> Result<Placement, Reported> {
    let group = braces(cursor, expected::base())?;
    let mut base = Placement::default();
    // What is left out is zero, whatever else could not be read.
    let _ = entries(cursor, &group, "base", &BASE, |cursor, key| {
        placement(cursor, key, &mut base)
    });
    Ok(base)
}

/// Reads `{ xyz: [x, y, z], rpy: [roll, pitch, yaw], mass: ..., com: [x, y, z], inertia: ... }`.
pub(super) fn tool(cursor: &mut Cursor) -> Result<Tool, Reported> {
    let group = braces(cursor, expected::tool())?;
    let mut tool = Tool::default();
    let outcome = entries(cursor, &group, "tool", &TOOL, |cursor, key| {
        match key.name {
            "mass" => fill(cursor, &mut tool.mass, key, expression),
            "com" => fill(cursor, &mut tool.com, key, vector),
            "inertia" => fill(cursor, &mut tool.inertia, key, inertia),
            "inertia_at_origin" => {
                fill(cursor, &mut tool.inertia_at_origin, key, inertia_at_origin)
            }
            "allow" => fill(cursor, &mut tool.allow, key, |cursor| {
                allow(cursor, &allow::OF_BODY)
            }),
            _ => placement(cursor, key, &mut tool.placement),
        }
    });
    if outcome.is_err() {
        tool.mass.doubt();
        tool.com.doubt();
    }
    Ok(tool)
}

/// Reads `key: value` items between the braces of an entry of that name.
fn entries<'t>(
    cursor: &Cursor<'t>,
    group: &Group<'t>,
    name: &str,
    known: &[&'static str],
    mut value: impl FnMut(&mut Cursor<'t>, Key) -> Result<(), Reported>,
) -> Result<(), Reported> {
    let what = format!("{name} entry");
    comma_separated(&mut cursor.inside(group), Cursor::at_key, |cursor| {
        let key = key(cursor, &what, known, |word| unknown(&what, word, known))?;
        let label = format!("`{}`", key.ident);
        value(cursor, key)?;
        Ok(label)
    })
}

fn placement(cursor: &mut Cursor, key: Key, placement: &mut Placement) -> Result<(), Reported> {
    match key.name {
        "xyz" => fill(cursor, &mut placement.xyz, key, vector),
        _ => fill(cursor, &mut placement.rpy, key, angles),
    }
}
