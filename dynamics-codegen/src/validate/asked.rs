//! The frames that functions are about, and the tip where they name none.

use std::collections::BTreeSet;

use dynamics_symbolic::robot::{Frame, Row};

use super::Parts;
use super::named::named;
use super::scope::Scope;
use crate::description::{Asked, Entry, Name, Place, Table, Wanted};
use crate::limits::MOST_LISTED;
use crate::mistake::{link as mistake, unknown};
use crate::words;

/// Reports functions of frames that are not there, functions of a tip and a tool where there is none, and frames that
/// nothing needs.
pub(super) fn report(parts: &Parts, table: &Table, scope: &Scope) {
    let asked = parts.functions.as_deref().unwrap_or_default();
    report_without_tip(asked, parts, table, scope);
    // A frame that could not be read may be the one that is requested, and a slip may mean one that seems to be idle.
    let is_unread =
        |entry: &Entry| matches!(entry, Entry::Frames(_, None) | Entry::Functions(None));
    let is_unreadable = |asked: &Asked| matches!(asked, Asked::Unreadable);
    let is_unknown = parts.has_unread_file
        || table.entries.iter().any(is_unread)
        || table.frames().any(|frame| frame.name.is_none());
    let are_known = report_frames(asked, is_unknown, table, scope);
    if are_known && !is_unknown && !asked.iter().any(is_unreadable) {
        report_idle(asked, table, scope);
    }
}

/// Reports functions that are about no frame, and frames that a table does not have, unless some could not be read.
/// Returns whether it has all of them.
fn report_frames(asked: &[Asked], is_unknown: bool, table: &Table, scope: &Scope) -> bool {
    let names: Vec<&str> = table.frame_names().map(Name::plain).collect();
    let known: BTreeSet<&str> = names.iter().copied().collect();
    let mut are_known = true;
    for wanted in named(asked) {
        let (Some(frame), function) = (&wanted.frame, wanted.function) else {
            continue;
        };
        let word = frame.plain();
        if !function.row().of_tip {
            scope.error(wanted.place, mistake::without_frame(wanted.name()));
        } else if !known.contains(word) && !is_unknown {
            are_known = false;
            let listed = &names[..names.len().min(MOST_LISTED)];
            let mistake = match listed {
                _ if table.rows().iter().any(|row| row.word() == word) => {
                    mistake::frame_of_joint(wanted.name(), word)
                }
                [] => mistake::no_frames(word),
                _ => unknown("frame", word, words::nearest(word, &names), listed),
            };
            scope.error(frame, mistake);
        }
    }
    are_known
}

/// Reports functions of the tip, and a tool, on a robot that has no tip.
fn report_without_tip(asked: &[Asked], parts: &Parts, table: &Table, scope: &Scope) {
    let Some(ends) = ends_without_tip(parts) else {
        return;
    };
    // A slip in `lock`, which is reported, may leave more ends than there are.
    if !parts.lock.iter().all(|lock| lock.is_of(table.rows())) {
        return;
    }
    let rows = table.rows();
    let tips: Vec<&str> = ends.iter().map(|&row| rows[row].word()).collect();
    let frames = from_the_ends(&ends, parts, table);
    // In a file, frames stand on links.
    let is_of_file = table.frames().any(|frame| frame.is_link);
    let link = if is_of_file { frames[0] } else { tips[0] };
    for entry in &table.entries {
        if let Entry::Tool(place, _) = entry {
            let mistake = match &tips[..] {
                [joint] => mistake::tool_without_end(joint, link),
                tips => mistake::tool_without_tip(tips, link),
            };
            scope.error(*place, mistake);
        }
    }
    // On a base that moves there is no inverse kinematics, at the tip or at a frame.
    let stands = table.floating().is_none();
    let is_of_tip = |wanted: &&Wanted| wanted.frame.is_none() && (stands || !wanted.is_inverse);
    let asked = named(asked).filter(is_of_tip);
    let asked = asked.map(|wanted| (wanted.function, wanted.name(), wanted.place));
    let needed = table.name.iter().zip(&table.needed);
    let needed = needed.map(|(name, function)| (*function, function.name(), Place::from(name)));
    for (function, name, place) in asked.chain(needed) {
        if function.row().of_tip {
            let mistake = match (&tips[..], &frames[..]) {
                (tips, []) => mistake::no_tip(name, tips),
                ([joint], frames) => mistake::no_end(name, joint, frames),
                (tips, frames) => mistake::no_tip_but_frames(name, tips, frames),
            };
            scope.error(place, mistake);
        }
    }
}

/// The rows that carry no other, if there is no tip. `None` if there is one, for no rows, and if a row is in error.
fn ends_without_tip(parts: &Parts) -> Option<Vec<usize>> {
    let rows: Vec<&Row> = parts
        .rows
        .as_ref()?
        .iter()
        .map(Option::as_ref)
        .collect::<Option<_>>()?;
    let is_end = |row: &usize| !(0..rows.len()).any(|i| rows[i].on.parent(i) == Some(*row));
    let ends: Vec<usize> = (0..rows.len()).filter(is_end).collect();
    let has_tip = if rows.iter().any(|row| row.mount.is_some()) {
        rows.iter().any(|row| row.tip().is_some())
    } else {
        ends.len() == 1
    };
    (!has_tip && !ends.is_empty()).then_some(ends)
}

/// The names of all frames: first the outermost link on each row that carries no other, where a file has links.
fn from_the_ends<'t>(ends: &[usize], parts: &Parts, table: &'t Table) -> Vec<&'t str> {
    let frames: Vec<_> = table.frames().zip(&parts.frames).collect();
    let links = frames.iter().rev().filter(|(frame, _)| frame.is_link);
    let last = |row: &usize| {
        let on = |read: &Option<Frame>| read.as_ref().is_some_and(|frame| frame.on == Some(*row));
        links.clone().find(|(_, read)| on(read))
    };
    let outermost = ends.iter().filter_map(last).map(|(frame, _)| frame.word());
    let mut names: Vec<&str> = outermost.collect();
    let others = table.frame_names().map(Name::plain);
    let others: Vec<&str> = others.filter(|name| !names.contains(name)).collect();
    names.extend(others);
    names
}

/// Reports frames of a call that have no body and that no function is about. Frames of a file are for all who read
/// it.
fn report_idle(asked: &[Asked], table: &Table, scope: &Scope) {
    let frames = named(asked).filter_map(|wanted| wanted.frame.as_ref());
    let of_functions: BTreeSet<&str> = frames.map(Name::plain).collect();
    let without_body = table
        .frames()
        .filter(|frame| !frame.is_link && !frame.body.is_written());
    for name in without_body.filter_map(|frame| frame.name.as_ref()) {
        let is_of_call = matches!(Place::from(name), Place::Tokens { .. });
        if is_of_call && !of_functions.contains(name.plain()) {
            scope.error(name, mistake::idle_frame(name.plain()));
        }
    }
}
