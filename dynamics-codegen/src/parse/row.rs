//! The rows of the table and their cells.

use std::cell::Cell;

use dynamics_symbolic::robot::JointType;
use proc_macro2::{Delimiter, Ident};

use super::allow::{self, allow};
use super::cursor::{Cursor, Group};
use super::expression::expression;
use super::inertia::{ENTRIES, inertia, inertia_at_origin};
use super::list::{Key, colon, comma_separated, fill, key};
use super::unknown::{Wrong, unknown};
use super::vector::{limits, vector};
use crate::description::{
    Coulomb, Expr, Friction, Given, Joints, Motor, Name, Row, Spring, Stribeck,
};
use crate::diagnose::Reported;
use crate::mistake::expected::Expected;
use crate::mistake::{self, expected};
use crate::place::Place;

/// The cells of a row.
pub(crate) const CELLS: [&str; 13] = [
    "a",
    "alpha",
    "d",
    "theta",
    "mass",
    "com",
    "inertia",
    "inertia_at_origin",
    "motor",
    "friction",
    "spring",
    "limits",
    "allow",
];

pub(crate) const MOTOR: [&str; 2] = ["inertia", "gear_ratio"];
pub(crate) const FRICTION: [&str; 3] = ["viscous", "coulomb", "stribeck"];
pub(crate) const DIRECTIONS: [&str; 2] = ["positive", "negative"];
pub(crate) const STRIBECK: [&str; 2] = ["static", "velocity"];
pub(crate) const SPRING: [&str; 2] = ["stiffness", "rest"];
pub(crate) const JOINT_TYPES: [&str; 2] = ["revolute", "prismatic"];

/// Reads the rows. One that holds an error is returned all the same: it counts, unless
/// it cannot be told where it ends.
pub(super) fn joints(mut cursor: Cursor) -> Joints {
    let mut rows = Vec::new();
    let complete = Cell::new(true);
    // What is no row behind a missing comma is skipped.
    let at_row = |cursor: &Cursor| {
        let at_row = cursor.at_key();
        complete.set(complete.get() && at_row);
        at_row
    };
    let _ = comma_separated(&mut cursor, at_row, |cursor| {
        if cursor.at(',') {
            return Err(cursor.expected(expected::joint()));
        }
        let mut row = Row::default();
        let end = row_into(cursor, &mut row);
        let at_end = cursor.at_end() || cursor.at(',');
        complete.set(complete.get() && (end.is_ok() || at_end));
        rows.push(row);
        end
    });
    Joints {
        rows,
        complete: complete.get(),
        tip: Vec::new(),
    }
}

/// Reads `name: revolute { cells }`.
fn row_into(cursor: &mut Cursor, row: &mut Row) -> Result<String, Reported> {
    let Some(name) = cursor.take_ident() else {
        return Err(cursor.expected(expected::joint()));
    };
    if let Some(group) = cursor.take_group(Delimiter::Parenthesis) {
        let place = Place::from(&name).to(group.span());
        return Err(cursor.error(place, mistake::joint::in_parentheses()));
    }
    let name = behind_extra_word(cursor, name);
    if name == "_" {
        cursor.error(&name, mistake::joint::unnamed());
    }
    let label = format!("joint `{name}`");
    let cells = cursor.take_group(Delimiter::Brace);
    let is_type = cells.is_some() && JOINT_TYPES.iter().any(|word| name == word);
    if name != "_" && !is_type {
        row.name = Some(Name::from(&name));
    }
    let cells = match cells {
        Some(cells) => {
            report_incomplete(cursor, &name, is_type);
            cells
        }
        None => {
            colon(cursor, &name.to_string())?;
            joint_type(cursor, &name, row);
            cursor.take_list(Delimiter::Brace, expected::cells(&label))?
        }
    };
    self::cells(cursor.inside(&cells), row);
    Ok(label)
}

/// Reports a word in front of a row's name. Returns the name.
fn behind_extra_word(cursor: &mut Cursor, word: Ident) -> Ident {
    match cursor.at_key().then(|| cursor.take_ident()).flatten() {
        Some(name) => {
            cursor.error(&word, mistake::joint::extra_word(&name));
            name
        }
        None => word,
    }
}

/// Reports a row of which one word alone stands in front of the cells.
fn report_incomplete(cursor: &Cursor, word: &Ident, is_type: bool) {
    let mistake = match is_type {
        true => mistake::joint::without_name(word),
        false => mistake::joint::without_type(word),
    };
    cursor.error(word, mistake);
}

/// Reads the joint's type. Without one, reading goes on at the cells.
fn joint_type(cursor: &mut Cursor, name: &Ident, row: &mut Row) {
    let Some(ident) = cursor.take_ident() else {
        cursor.expected(expected::joint_type(name, &JOINT_TYPES));
        return;
    };
    let word = ident.to_string();
    row.joint_type = match word.as_str() {
        "revolute" => Some(JointType::Revolute),
        "prismatic" => Some(JointType::Prismatic),
        "fixed" => {
            cursor.error(&ident, mistake::joint::fixed(name));
            None
        }
        _ => {
            let wrong = unknown("joint type", &word, &JOINT_TYPES);
            cursor.error(&ident, wrong.mistake);
            None
        }
    };
}

fn cells(mut cursor: Cursor, row: &mut Row) {
    let outcome = comma_separated(&mut cursor, Cursor::at_key, |cursor| {
        let key = key(cursor, "cell", &CELLS, unknown_cell)?;
        let what = format!("the cell `{}`", key.ident);
        cell(cursor, key, row)?;
        Ok(what)
    });
    if outcome.is_err() {
        row.mass.doubt();
        row.com.doubt();
    }
}

fn cell(cursor: &mut Cursor, key: Key, row: &mut Row) -> Result<(), Reported> {
    match key.name {
        "a" => fill(cursor, &mut row.a, key, expression),
        "alpha" => fill(cursor, &mut row.alpha, key, expression),
        "d" => fill(cursor, &mut row.d, key, expression),
        "theta" => fill(cursor, &mut row.theta, key, expression),
        "mass" => fill(cursor, &mut row.mass, key, expression),
        "com" => fill(cursor, &mut row.com, key, vector),
        "inertia" => fill(cursor, &mut row.inertia, key, inertia),
        "inertia_at_origin" => fill(cursor, &mut row.inertia_at_origin, key, inertia_at_origin),
        "motor" => fill(cursor, &mut row.motor, key, motor),
        "friction" => fill(cursor, &mut row.friction, key, friction),
        "spring" => fill(cursor, &mut row.spring, key, spring),
        "limits" => fill(cursor, &mut row.limits, key, limits),
        _ => fill(cursor, &mut row.allow, key, |cursor| {
            allow(cursor, &allow::OF_BODY)
        }),
    }
}

/// The message for a word that is no cell; it may be at home elsewhere.
pub(crate) fn unknown_cell(word: &str) -> Wrong {
    let home = [
        ("motor", MOTOR.as_slice()),
        ("friction", FRICTION.as_slice()),
        ("spring", SPRING.as_slice()),
        ("inertia", ENTRIES.as_slice()),
    ];
    match home.iter().find(|(_, words)| words.contains(&word)) {
        Some((cell, _)) => Wrong {
            mistake: mistake::joint::cell_elsewhere(word, cell),
            meant: None,
        },
        None => unknown("cell", word, &CELLS),
    }
}

fn motor(cursor: &mut Cursor) -> Result<Motor, Reported> {
    let group = braces(cursor, expected::motor())?;
    let mut motor = Motor {
        place: group.span().into(),
        inertia: Default::default(),
        gear_ratio: Default::default(),
    };
    let outcome = comma_separated(&mut cursor.inside(&group), Cursor::at_key, |cursor| {
        let unknown = |word: &str| unknown("motor entry", word, &MOTOR);
        let key = key(cursor, "motor entry", &MOTOR, unknown)?;
        let what = format!("`{}`", key.ident);
        let slot = match key.name {
            "inertia" => &mut motor.inertia,
            _ => &mut motor.gear_ratio,
        };
        fill(cursor, slot, key, expression)?;
        Ok(what)
    });
    if outcome.is_err() {
        motor.gear_ratio.doubt();
    }
    Ok(motor)
}

fn friction(cursor: &mut Cursor) -> Result<Friction, Reported> {
    let group = braces(cursor, expected::friction())?;
    let mut friction = Friction::default();
    // A coefficient that is left out is zero, whatever else could not be read.
    let _ = comma_separated(&mut cursor.inside(&group), Cursor::at_key, |cursor| {
        let unknown = |word: &str| unknown("friction entry", word, &FRICTION);
        let key = key(cursor, "friction entry", &FRICTION, unknown)?;
        let what = format!("`{}`", key.ident);
        match key.name {
            "viscous" => fill(cursor, &mut friction.viscous, key, expression),
            "coulomb" => fill(cursor, &mut friction.coulomb, key, coulomb),
            _ => fill(cursor, &mut friction.stribeck, key, stribeck),
        }?;
        Ok(what)
    });
    Ok(friction)
}

/// Reads a value, or `{ positive, negative }`.
fn coulomb(cursor: &mut Cursor) -> Result<Coulomb, Reported> {
    let Some(group) = cursor.take_group(Delimiter::Brace) else {
        return expression(cursor).map(|value| Coulomb::Both(Given::As(value)));
    };
    let [positive, negative] = entries(cursor.inside(&group), "direction", DIRECTIONS);
    Ok(Coulomb::ByDirection {
        place: group.span().into(),
        positive,
        negative,
    })
}

fn stribeck(cursor: &mut Cursor) -> Result<Stribeck, Reported> {
    let group = braces(cursor, expected::stribeck())?;
    let [friction, velocity] = entries(cursor.inside(&group), "stribeck entry", STRIBECK);
    Ok(Stribeck {
        place: group.span().into(),
        friction,
        velocity,
    })
}

/// Reads `name: value` for each of some names, all of which are needed: one that is not there may be
/// what could not be read.
fn entries<const N: usize>(
    mut cursor: Cursor,
    kind: &str,
    names: [&'static str; N],
) -> [Given<Expr>; N] {
    let mut values = [(); N].map(|()| Given::Absent);
    let outcome = comma_separated(&mut cursor, Cursor::at_key, |cursor| {
        let key = key(cursor, kind, &names, |word| unknown(kind, word, &names))?;
        let what = format!("`{}`", key.ident);
        let index = names.iter().position(|name| *name == key.name);
        fill(cursor, &mut values[index.unwrap_or(0)], key, expression)?;
        Ok(what)
    });
    if outcome.is_err() {
        values.iter_mut().for_each(Given::doubt);
    }
    values
}

fn spring(cursor: &mut Cursor) -> Result<Spring, Reported> {
    let group = braces(cursor, expected::spring())?;
    let [stiffness, rest] = entries(cursor.inside(&group), "spring entry", SPRING);
    Ok(Spring {
        place: group.span().into(),
        stiffness,
        rest,
    })
}

/// Takes braces, where `what` is expected.
pub(super) fn braces<'t>(cursor: &mut Cursor<'t>, what: Expected) -> Result<Group<'t>, Reported> {
    cursor
        .take_group(Delimiter::Brace)
        .ok_or_else(|| cursor.expected(what))
}
