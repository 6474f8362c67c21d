//! The share below which terms are neglected.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{JointType, Value};

use super::scope::Scope;
use super::{Parts, named};
use crate::description::{Share, Table};
use crate::diagnose::Diagnostics;
use crate::mistake::entry as mistake;
use crate::place::Place;

/// The share, between 0 and 1.
pub(super) fn share(share: Option<&Share>, scope: &mut Scope) -> Option<(Value, Place)> {
    let share = share?;
    let mut value = scope.value(&share.number)?;
    if !value.is_number() {
        return scope.refused(share.place, mistake::share_with_field());
    }
    if share.percent {
        value = value.checked_div(Value::Rational(Rational::from(100)))?;
    }
    let size = value.to_f64(&[]);
    if size <= 0.0 {
        return scope.refused(share.place, mistake::share_of_nothing());
    }
    if size >= 1.0 {
        let mistake = mistake::share_of_more_than_all(size, share.percent);
        return scope.refused(share.place, mistake);
    }
    Some((value, share.place))
}

/// Reports what `neglect` needs and is not there: numbers, ranges.
pub(super) fn report(parts: &Parts, table: &Table, diagnostics: &Diagnostics) {
    // On a base that moves nothing is neglected, whatever else is there.
    let neglect = parts.neglect.as_ref();
    let Some((_, place)) = neglect.filter(|_| table.floating().is_none()) else {
        return;
    };
    if let Some(tests) = &parts.tests {
        diagnostics.error(*tests, mistake::neglect_and_tests());
    }
    for wanted in named::named(parts.functions.as_deref().unwrap_or_default()) {
        if wanted.function.is_about_base_parameters() {
            let mistake = mistake::neglect_and_identification(wanted.function.name());
            diagnostics.error(wanted.place, mistake);
        }
    }
    if let Some(name) = table.fields.first() {
        diagnostics.error(*place, mistake::neglect_and_field(name));
    }
    let rows = parts.rows.iter().flatten().zip(table.rows());
    for (row, written) in rows {
        let (Some(row), Some(name)) = (row, &written.name) else {
            continue;
        };
        let needs_limits = row.joint_type == JointType::Prismatic && row.is_free();
        if needs_limits && row.limits.is_none() {
            diagnostics.error(name, mistake::neglect_without_limits(name));
        }
    }
}
