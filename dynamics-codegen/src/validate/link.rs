//! The links that carry joints and frames, and where a row begins on its link.

use dynamics_symbolic::robot::{Carrier, Convention, Placement, Value};

use super::scope::Scope;
use crate::description::{self, Entry, Given, Link, Name, Row, Table};
use crate::mistake::{link as mistake, unknown};
use crate::words;

/// The word for the base.
pub(super) const BASE: &str = "base";

/// The link that carries the joint of a row; `None` where it is in error. The row above, and the base for the first row,
/// are the same whether they are named or not.
pub(super) fn of_row(index: usize, table: &Table, scope: &Scope) -> Option<Carrier> {
    let above = index.checked_sub(1);
    let parent = table.rows()[index].on.read(above, |link| match link {
        Link::Row(row) => Some(*row),
        Link::Named(name) => carrier(name, index, table, scope),
    })?;
    Some(match parent {
        parent if parent == above => Carrier::Above,
        None => Carrier::Base,
        Some(row) => Carrier::Row(row),
    })
}

/// The row of that name, which stands above row `index`; `None` inside for the base.
fn carrier(name: &Name, index: usize, table: &Table, scope: &Scope) -> Option<Option<usize>> {
    let row = named(name, index, table, scope)?;
    let mistake = match row {
        Some(row) if row == index => mistake::on_itself(name.plain()),
        Some(row) if row > index => {
            mistake::on_a_row_below(name.plain(), table.rows()[index].word())
        }
        _ => return Some(row),
    };
    scope.refused(name.into(), mistake)
}

/// The row whose link carries a frame, `None` for the base, and where a file has the link's frame in that row's. Outer
/// `None`: in error.
pub(super) fn of_frame<'t>(
    frame: &Name,
    on: &Given<Link>,
    table: &'t Table,
    scope: &Scope,
) -> Option<(Option<usize>, &'t [Placement])> {
    match on {
        Given::Absent => scope.refused(frame.into(), mistake::without_link(frame.plain())),
        Given::Unreadable => None,
        Given::As(Link::Row(row)) => Some((*row, &[])),
        Given::As(Link::Named(name)) => {
            let mut frames = table.frames();
            let link = frames.find(|frame| frame.is_link && frame.word() == name.plain());
            if let Some((Given::As(Link::Row(row)), places)) = link.map(|l| (&l.on, &l.places)) {
                return Some((*row, places));
            }
            let row = named(name, table.rows().len(), table, scope)?;
            Some((row, &[]))
        }
    }
}

/// The row of that name; `None` inside for the base. Outer `None`: there is none, which is reported with the names of
/// the first rows, so many as are possible.
fn named(name: &Name, possible: usize, table: &Table, scope: &Scope) -> Option<Option<usize>> {
    let (word, rows) = (name.plain(), table.rows());
    let row = rows.iter().position(|row| row.word() == word);
    // A row that could not be read may have the name.
    let is_complete = table.joints().is_some_and(|joints| joints.complete);
    let is_complete = is_complete && rows.iter().all(|row| row.name.is_some());
    let mistake = match row {
        Some(_) if word == BASE => mistake::joint_named_base(),
        Some(row) => return Some(Some(row)),
        None if word == BASE => return Some(None),
        None if table.frame_names().any(|frame| frame.plain() == word) => mistake::on_a_frame(word),
        None if is_complete => {
            let all: Vec<&str> = rows.iter().map(Row::word).chain([BASE]).collect();
            let possible = [&all[..possible], &[BASE]].concat();
            unknown("joint", word, words::nearest(word, &all), &possible)
        }
        None => return None,
    };
    scope.refused(name.into(), mistake)
}

/// The place of a frame; `None` where it is in error.
pub(super) fn placement(
    placement: &description::Placement,
    scope: &mut Scope,
) -> Option<Placement> {
    let xyz = scope.given_vector(&placement.xyz);
    let rpy = scope.angles(&placement.rpy);
    Some(Placement {
        xyz: xyz?,
        rpy: rpy?,
    })
}

/// Where a row begins on the link that carries it, each place in the one before it. `gamma` and `b` are
/// Rz(gamma) Tz(b) (Khalil and Kleinfinger 1986).
pub(super) fn beginning(row: &Row, table: &Table, scope: &mut Scope) -> Option<Vec<Placement>> {
    let at = row.at.read(None, |at| placement(at, scope).map(Some));
    let (gamma, b) = (scope.angle(&row.gamma), scope.given(&row.b));
    let is_standard =
        |entry: &Entry| matches!(entry, Entry::Convention(Some(Convention::Standard)));
    let written = [("gamma", &row.gamma), ("b", &row.b)];
    let first = written
        .iter()
        .find_map(|(word, cell)| Some((word, cell.value()?.place)));
    if let Some((word, place)) = first {
        if !row.at.is_absent() {
            return scope.refused(place, mistake::two_places(word));
        }
        if table.entries.iter().any(is_standard) {
            return scope.refused(place, mistake::of_modified_tables(word));
        }
    }
    let (gamma, b, zero) = (gamma?, b?, Value::zero);
    let of_khalil = first.map(|_| Placement {
        xyz: [zero(), zero(), b],
        rpy: [zero(), zero(), gamma],
    });
    Some(
        row.places
            .iter()
            .cloned()
            .chain(at?)
            .chain(of_khalil)
            .collect(),
    )
}
