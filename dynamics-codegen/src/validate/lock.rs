//! Joints that are locked at a position.

use std::collections::BTreeSet;

use dynamics_symbolic::robot::{JointType, Row, Value};

use super::angle::Odd;
use super::known::number;
use super::scope::Scope;
use crate::description::{self, Name};
use crate::mistake::entry as mistake;
use crate::place::Place;

/// A joint and the position at which it is locked; `None` where that is in error.
pub(super) struct Lock {
    name: Name,
    position: Option<Position>,
}

impl Lock {
    /// Whether the joint is one of these.
    pub(super) fn is_of(&self, rows: &[description::Row]) -> bool {
        rows.iter().any(|row| row.word() == self.name.plain())
    }
}

struct Position {
    value: Value,
    /// The oddity of it, where it is an angle.
    odd: Option<Odd>,
    place: Place,
}

/// The positions, in the scope of the place where they are written.
pub(super) fn positions(
    locked: Option<&[description::Positioned]>,
    scope: &mut Scope,
) -> Vec<Lock> {
    let lock = |locked: &description::Positioned| Lock {
        name: locked.name.clone(),
        position: locked.position.as_ref().and_then(|position| {
            let (value, odd) = scope.unjudged_angle(position)?;
            let place = position.place;
            Some(Position { value, odd, place })
        }),
    };
    locked.unwrap_or_default().iter().map(lock).collect()
}

/// Adds the locks of one list to those of others: the file's and those beside it. A joint may stand in two lists at the
/// same position; at two positions it is a mistake.
pub(super) fn join(locks: &mut Vec<Lock>, list: Vec<Lock>, scope: &Scope) {
    let before = locks.len();
    for lock in list {
        let word = lock.name.plain();
        let mut known = locks[..before].iter();
        let Some(known) = known.find(|known| known.name.plain() == word) else {
            locks.push(lock);
            continue;
        };
        if let (Some(one), Some(other)) = (&known.position, &lock.position) {
            let [a, b] = [&one.value, &other.value].map(number);
            if one.value != other.value && (a.is_none() || a != b) {
                scope.error(&lock.name, mistake::locked_at_two(word, a, b));
            }
        }
    }
}

/// Locks the rows' joints; whether that leaves none. A row that is in error (`None`) is known by its name alone.
pub(super) fn lock(
    rows: &mut [Option<Row>],
    locks: &[Lock],
    written: &[description::Row],
    scope: &Scope,
) -> bool {
    let mut locked = BTreeSet::new();
    for lock in locks {
        let Some(index) = scope.row_of(&lock.name, written) else {
            continue;
        };
        if !locked.insert(index) {
            scope.error(&lock.name, mistake::locked_twice(lock.name.plain()));
        }
        if let (Some(row), Some(position)) = (&mut rows[index], &lock.position) {
            report_position(row, position, scope);
            row.locked = Some(position.value.clone());
        }
    }
    locked.len() == written.len()
}

/// Reports that no joint is left, where those that follow locked ones are locked too. A table that is in
/// error otherwise may not be all that there is.
pub(super) fn report_all_locked(
    rows: &[Option<Row>],
    locks: &[Lock],
    is_good: bool,
    scope: &Scope,
) {
    let is_locked = |row: &Option<Row>| row.as_ref().is_some_and(|row| row.locked.is_some());
    if is_good && rows.iter().all(is_locked) {
        report_all(locks, scope);
    }
}

pub(super) fn report_all(locks: &[Lock], scope: &Scope) {
    if let (Some(first), Some(last)) = (locks.first(), locks.last()) {
        let place = Place::from(&first.name).to(&last.name);
        scope.error(place, mistake::all_locked());
    }
}

/// Reports a position beyond the limits of a joint that stands still there; whether it did.
pub(super) fn report_out_of_limits(
    row: &Row,
    position: &Value,
    place: Place,
    scope: &Scope,
) -> bool {
    let (Some(number), Some(limits)) = (number(position), &row.limits) else {
        return false;
    };
    let [lower, upper] = limits.each_ref().map(|limit| limit.to_f64(&[]));
    let is_outside = !(lower..=upper).contains(&number);
    if is_outside {
        let mistake = mistake::locked_out_of_limits(number, &row.name, lower, upper);
        scope.error(place, mistake);
    }
    is_outside
}

/// Reports a position beyond the joint's limits, and an angle that was hardly meant. One of many turns is
/// good where the limits say so.
fn report_position(row: &Row, position: &Position, scope: &Scope) {
    let is_outside = report_out_of_limits(row, &position.value, position.place, scope);
    if let (Some(odd), JointType::Revolute, false) = (&position.odd, row.joint_type, is_outside)
        && (row.limits.is_none() || matches!(odd, Odd::NearlyRight(_)))
    {
        scope.report_odd(odd, position.place);
    }
}
