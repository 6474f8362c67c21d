//! Cells that a file lacks or has wrong, beside it: `joints: { elbow: { friction: { viscous: 0.1 } } }`.

use crate::description::{Allow, Entry, Given, Name, Row};
use crate::diagnose::Diagnostics;
use crate::mistake::{Mistake, file as mistake, unknown};
use crate::place::Place;
use crate::words;

/// Takes the cells out of the entries beside a file. Returns how many entries stand in front of them, too.
pub(super) fn take(entries: &mut Vec<Entry>) -> Option<(usize, Place, Vec<Row>)> {
    let is_beside = |entry: &Entry| matches!(entry, Entry::Beside(..));
    let at = entries.iter().position(is_beside)?;
    match entries.remove(at) {
        Entry::Beside(place, Some(rows)) => Some((at, place, rows)),
        _ => None,
    }
}

/// Puts the cells in the rows of a file's entries. A joint that has no row is reported; `all` are the names of all joints
/// in the file.
pub(super) fn put(
    (place, cells): (Place, Vec<Row>),
    entries: &mut [Entry],
    all: impl Fn() -> Vec<String>,
    diagnostics: &Diagnostics,
) {
    let joints = entries.iter_mut().find_map(|entry| match entry {
        Entry::Joints(_, joints) => joints.as_mut(),
        _ => None,
    });
    let Some(joints) = joints else {
        return;
    };
    if cells.is_empty() {
        diagnostics.error(place, mistake::no_joint_of_file());
    }
    for cells in cells {
        let rows = &mut joints.rows;
        match (
            rows.iter().position(|row| row.word() == cells.word()),
            &cells.name,
        ) {
            (Some(row), _) => replace(&mut rows[row], cells),
            (None, Some(name)) if joints.complete => {
                diagnostics.error(name, no_row(name, rows, &all()));
            }
            (None, _) => {}
        }
    }
}

/// The mistake of a name that no row has.
fn no_row(name: &Name, rows: &[Row], all: &[String]) -> Mistake {
    if all.iter().any(|joint| joint == name.plain()) {
        return mistake::not_of_the_arm(name.plain());
    }
    let known: Vec<&str> = rows.iter().map(Row::word).collect();
    unknown(
        "joint",
        name.plain(),
        words::nearest(name.plain(), &known),
        &known,
    )
}

/// Replaces the cells of a row by those that are given.
fn replace(row: &mut Row, cells: Row) {
    row.limits_of_file &= cells.limits.is_absent();
    replace_cell(&mut row.motor, cells.motor);
    replace_cell(&mut row.friction, cells.friction);
    replace_cell(&mut row.spring, cells.spring);
    replace_cell(&mut row.limits, cells.limits);
    replace_cell(&mut row.torque_limit, cells.torque_limit);
    replace_cell(&mut row.velocity_limit, cells.velocity_limit);
    // A URDF file has no such cell: its reader has judged the bodies.
    let of_reader = row.mount.is_some().then(|| row.body.allow.value().copied());
    let of_reader = of_reader.flatten().unwrap_or_default();
    let allow = match cells.body.allow {
        Given::As(allow) => Given::As(Allow::or(allow, of_reader)),
        other => other,
    };
    replace_cell(&mut row.body.allow, allow);
}

fn replace_cell<T>(cell: &mut Given<T>, given: Given<T>) {
    if !given.is_absent() {
        *cell = given;
    }
}

/// Moves the rows of the joints behind so many entries, where they are not: their cells may use names that are bound
/// in front of them.
pub(super) fn move_rows(entries: &mut [Entry], behind: usize) {
    let is_joints = |entry: &Entry| matches!(entry, Entry::Joints(..));
    if let Some(at) = entries.iter().position(is_joints)
        && at < behind
    {
        entries[at..behind].rotate_left(1);
    }
}
