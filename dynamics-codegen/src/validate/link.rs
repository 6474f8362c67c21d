//! The links that carry joints and frames, and where a row begins on its link.

use dynamics_symbolic::robot::{Carrier, Convention, Placement, Value};

use super::frames::placement;
use super::scope::Scope;
use crate::description::{Entry, Given, Link, Name, Row, Table};
use crate::mistake::{link as mistake, unknown};
use crate::words;

/// The word for the base.
pub(super) const BASE: &str = "base";

/// The link that carries the joint of a row; `None` where it is in error.
pub(super) fn of_row(index: usize, table: &Table, scope: &Scope) -> Option<Carrier> {
    let rows = table.rows();
    rows[index].on.read(Carrier::Above, |link| {
        let name = match link {
            Link::Row(row) => return Some(row.map_or(Carrier::Base, Carrier::Row)),
            Link::Named(name) => name,
        };
        match named(name, &rows[..index], table, scope)? {
            None => Some(Carrier::Base),
            Some(row) if row < index => Some(Carrier::Row(row)),
            Some(row) if row == index => {
                scope.refused(name.into(), mistake::on_itself(name.plain()))
            }
            Some(_) => {
                let mistake = mistake::on_a_row_below(name.plain(), rows[index].word());
                scope.refused(name.into(), mistake)
            }
        }
    })
}

/// The row whose link carries a frame; `None` inside for the base. Outer `None`: in error.
pub(super) fn of_frame(
    frame: &Name,
    on: &Given<Link>,
    table: &Table,
    scope: &Scope,
) -> Option<Option<usize>> {
    match on {
        Given::Absent => scope.refused(frame.into(), mistake::without_link(frame.plain())),
        Given::Unreadable => None,
        Given::As(Link::Row(row)) => Some(*row),
        Given::As(Link::Named(name)) => named(name, table.rows(), table, scope),
    }
}

/// The row of that name; `None` inside for the base. Outer `None`: there is none, which is reported with the names of
/// the rows that may be meant.
fn named(name: &Name, possible: &[Row], table: &Table, scope: &Scope) -> Option<Option<usize>> {
    let word = name.plain();
    let row = table.rows().iter().position(|row| row.word() == word);
    if word == BASE {
        return match row {
            Some(_) => scope.refused(name.into(), mistake::joint_named_base()),
            None => Some(None),
        };
    }
    if row.is_some() {
        return Some(row);
    }
    let is_frame = |other: &Name| other.plain() == word;
    if table
        .frames()
        .filter_map(|frame| frame.name.as_ref())
        .any(is_frame)
    {
        return scope.refused(name.into(), mistake::on_a_frame(word));
    }
    // A row that could not be read may have the name.
    let is_complete = table.joints().is_some_and(|joints| joints.complete);
    if is_complete && table.rows().iter().all(|row| row.name.is_some()) {
        let known = |rows: &[Row]| -> Vec<String> {
            let names = rows.iter().map(|row| row.word().to_owned());
            names.chain([BASE.to_owned()]).collect()
        };
        let (all, possible) = (known(table.rows()), known(possible));
        let [all, possible] =
            [&all, &possible].map(|names| names.iter().map(String::as_str).collect::<Vec<_>>());
        let meant = words::nearest(word, &all);
        scope.error(name, unknown("joint", word, meant, &possible));
    }
    None
}

/// Where a row begins on the link that carries it, each place in the one before it. `gamma` and `b` are
/// Rz(gamma) Tz(b) (Khalil and Kleinfinger 1986).
pub(super) fn beginning(row: &Row, table: &Table, scope: &mut Scope) -> Option<Vec<Placement>> {
    let mut places = row.places.clone();
    let at = row.at.read(None, |at| placement(at, scope).map(Some));
    let gamma = scope.angle(&row.gamma);
    let b = scope.given(&row.b);
    let of_khalil = [("gamma", &row.gamma), ("b", &row.b)];
    let mut written = of_khalil
        .iter()
        .filter_map(|(word, cell)| Some((word, cell.value()?)));
    if let Some((word, cell)) = written.next() {
        if !row.at.is_absent() {
            return scope.refused(cell.place, mistake::two_places(word));
        }
        if is_standard(table) {
            return scope.refused(cell.place, mistake::of_modified_tables(word));
        }
    }
    places.extend(at?);
    let (gamma, b) = (gamma?, b?);
    if of_khalil.iter().any(|(_, cell)| !cell.is_absent()) {
        let zero = Value::zero;
        places.push(Placement {
            xyz: [zero(), zero(), b],
            rpy: [zero(), zero(), gamma],
        });
    }
    Some(places)
}

fn is_standard(table: &Table) -> bool {
    let mut entries = table.entries.iter();
    entries.any(|entry| matches!(entry, Entry::Convention(Some(Convention::Standard))))
}
