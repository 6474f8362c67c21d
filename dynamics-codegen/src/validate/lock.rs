//! Joints that are locked at a position.

use dynamics_symbolic::robot::{Row, Value};

use super::scope::Scope;
use crate::description::{self, Name};
use crate::diagnose::Diagnostics;
use crate::mistake::{Mistake, entry as mistake};
use crate::place::Place;
use crate::words;

/// A joint and the position at which it is locked; `None` where that is in error.
pub(super) struct Lock {
    name: Name,
    position: Option<(Value, Place)>,
}

/// The positions, in the scope of the place where they are written.
pub(super) fn positions(locked: Option<&[description::Locked]>, scope: &mut Scope) -> Vec<Lock> {
    let lock = |locked: &description::Locked| Lock {
        name: locked.name.clone(),
        position: locked.position.as_ref().and_then(|position| {
            let value = scope.value(position)?;
            Some((value, position.place))
        }),
    };
    locked.unwrap_or_default().iter().map(lock).collect()
}

/// Locks the rows' joints, of which one at least must be left. A row that is in error (`None`) is
/// known by its name alone.
pub(super) fn lock(
    rows: &mut [Option<Row>],
    locks: &[Lock],
    written: &[description::Row],
    diagnostics: &Diagnostics,
) {
    let name = |row: &description::Row| {
        row.name
            .as_ref()
            .map_or(String::new(), |name| name.plain().to_owned())
    };
    let names: Vec<String> = written.iter().map(name).collect();
    let mut locked = vec![false; names.len()];
    for lock in locks {
        let word = lock.name.plain();
        let Some(index) = names.iter().position(|name| name == word) else {
            diagnostics.error(&lock.name, unknown(word, &names));
            return;
        };
        if locked[index] {
            diagnostics.error(&lock.name, mistake::locked_twice(word));
        }
        locked[index] = true;
        if let (Some(row), Some((value, place))) = (&mut rows[index], &lock.position) {
            report_out_of_limits(row, value, *place, diagnostics);
            row.locked = Some(value.clone());
        }
    }
    if let Some(first) = locks
        .first()
        .filter(|_| locked.iter().all(|locked| *locked))
    {
        let last = locks.last().unwrap_or(first);
        let place = Place::from(&first.name).to(&last.name);
        diagnostics.error(place, mistake::all_locked());
    }
}

fn unknown(word: &str, names: &[String]) -> Mistake {
    let known = names.iter().map(String::as_str);
    let known: Vec<&str> = known.filter(|name| !name.is_empty()).collect();
    mistake::unknown_joint(word, words::nearest(word, &known), &known)
}

fn report_out_of_limits(row: &Row, value: &Value, place: Place, diagnostics: &Diagnostics) {
    let Some([lower, upper]) = row.limits.as_ref().filter(|_| value.is_number()) else {
        return;
    };
    let [lower, value, upper] = [lower, value, upper].map(|value| value.to_f64(&[]));
    if !(lower..=upper).contains(&value) {
        let mistake = mistake::locked_out_of_limits(value, &row.name, [lower, upper]);
        diagnostics.error(place, mistake);
    }
}
