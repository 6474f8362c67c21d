//! The share below which terms are neglected.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{JointType, Value};

use super::scope::Scope;
use super::{Parts, rows_of};
use crate::diagnose::{Diagnostics, Place};
use crate::syntax::{Call, Share};

/// The share, between 0 and 1.
pub(super) fn share(share: Option<&Share>, scope: &mut Scope) -> Option<(Value, Place)> {
    let share = share?;
    let mut value = scope.value(&share.number)?;
    if !value.is_number() {
        let message = "a share is a number: it does not depend on a field";
        scope.error(share.place, message);
        return None;
    }
    if share.percent {
        value = value.checked_div(Value::Rational(Rational::from(100)))?;
    }
    let size = value.to_f64(&[]);
    if size <= 0.0 {
        scope.error(share.place, "a share is above 0, `1%` for example");
        return None;
    }
    if size >= 1.0 {
        let message = match share.percent {
            true => "a share is below 100%".to_owned(),
            false => format!("a share is below 1: `{size}%` is {size} parts of a hundred"),
        };
        scope.error(share.place, message);
        return None;
    }
    Some((value, share.place))
}

/// Reports what `neglect` needs and is not there: numbers, ranges.
pub(super) fn report(parts: &Parts, call: &Call, diagnostics: &Diagnostics) {
    let Some((_, place)) = &parts.neglect else {
        return;
    };
    if let Some(tests) = &parts.tests {
        let message = "`tests: true` compares with the whole table, of which `neglect` leaves a part out: \
                       leave one of the two away";
        diagnostics.error(*tests, message);
    }
    for (function, place) in parts.functions.iter().flatten() {
        if function.is_about_base_parameters() {
            let message = format!(
                "`{}` is about all base parameters, some of which `neglect` leaves out: leave one of the \
                 two away",
                function.name()
            );
            diagnostics.error(*place, message);
        }
    }
    let fields = call.structure.iter().flat_map(|s| &s.fields);
    if let Some(name) = fields.filter_map(|field| field.name.as_ref()).next() {
        let message = format!(
            "what may be neglected depends on numbers: the value of the field `{name}` is not known here"
        );
        diagnostics.error(*place, message);
    }
    let rows = parts.rows.iter().flatten().zip(rows_of(call));
    for (row, written) in rows {
        let (Some(row), Some(name)) = (row, &written.name) else {
            continue;
        };
        let needs_limits = row.joint_type == JointType::Prismatic && row.locked.is_none();
        if needs_limits && row.limits.is_none() {
            let message = format!(
                "`neglect` needs to know how far `{name}` slides: write `limits: [lower, upper]`, in m"
            );
            diagnostics.error(name, message);
        }
    }
}
