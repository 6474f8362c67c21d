//! Cells that a file lacks or has wrong, beside it: `joints: { elbow: { friction: { viscous: 0.1 } } }`, and
//! `links: { hand: { mass: load } }`.

use crate::description::{Allow, Body, Entry, Given, Name, Row};
use crate::diagnose::Diagnostics;
use crate::files::Format;
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

/// Cells of links, by their names.
type OfLinks = Vec<(Name, Body)>;

/// Takes the cells of links out of the entries beside a file. Returns how many entries stand in front of them, too.
pub(super) fn take_links(entries: &mut Vec<Entry>) -> Option<(usize, Place, OfLinks)> {
    let is_links = |entry: &Entry| matches!(entry, Entry::Links(..));
    let at = entries.iter().position(is_links)?;
    match entries.remove(at) {
        Entry::Links(place, links) => Some((at, place, links?)),
        _ => None,
    }
}

/// How many entries stand in front of the last cells, if those of joints were taken out before those of links.
pub(super) fn in_front(joints: Option<usize>, links: Option<usize>) -> usize {
    let is_behind = |joints: usize| links.is_some_and(|links| links < joints);
    let joints = joints.map_or(0, |at| at - usize::from(is_behind(at)));
    joints.max(links.unwrap_or(0))
}

/// Puts the cells of links in the frames of a file's links, which have the bodies of the file. A table has no links.
pub(super) fn put_links(
    (place, links): (Place, OfLinks),
    entries: &mut [Entry],
    format: Format,
    diagnostics: &Diagnostics,
) {
    if format != Format::Urdf {
        diagnostics.error(place, mistake::links_of_a_table());
        return;
    }
    let frames = entries.iter_mut().find_map(|entry| match entry {
        Entry::Frames(_, frames) => frames.as_mut(),
        _ => None,
    });
    // A file that could not be read has none.
    let Some(frames) = frames else {
        return;
    };
    if links.is_empty() {
        diagnostics.error(place, mistake::no_link_of_file());
    }
    for (name, cells) in links {
        let mut of_links = frames.iter_mut().filter(|frame| frame.is_link);
        let Some(frame) = of_links.find(|frame| frame.word() == name.plain()) else {
            diagnostics.error(&name, mistake::not_of_the_robot(name.plain()));
            continue;
        };
        replace_cell(&mut frame.body.mass, cells.mass);
        replace_cell(&mut frame.body.com, cells.com);
        replace_cell(&mut frame.body.inertia, cells.inertia);
        frame.body.allow = Given::Absent;
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

/// Moves the rows of the joints, and the frames of links, behind so many entries, where they are not: their cells may use names
/// that are bound in front of them.
pub(super) fn move_cells(entries: &mut [Entry], behind: usize) {
    for has_cells in [
        |entry: &Entry| matches!(entry, Entry::Joints(..)),
        |entry: &Entry| matches!(entry, Entry::Frames(..)),
    ] {
        if let Some(at) = entries.iter().position(has_cells)
            && at < behind
        {
            entries[at..behind].rotate_left(1);
        }
    }
}
