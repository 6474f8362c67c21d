//! The range of a joint.

use dynamics_symbolic::robot::{JointType, Value};

use super::scope::Scope;
use crate::description::{self, Expr, Given};
use crate::mistake::{Mistake, joint as mistake};

/// A revolute joint does not turn so far, in rad, unless its position is written in terms of PI: five
/// turns.
const MANY_TURNS: f64 = 10.0 * core::f64::consts::PI;

/// Both limits. Outer `None`: in error; inner `None`: not written.
pub(super) fn limits(row: &description::Row, scope: &mut Scope) -> Option<Option<[Value; 2]>> {
    let limits = match &row.limits {
        Given::Absent => return Some(None),
        Given::Unreadable => return None,
        Given::As(limits) => limits,
    };
    let [lower, upper] = limits.each_ref().map(|limit| {
        limit
            .as_ref()
            .and_then(|limit| self::limit(limit, row, scope))
    });
    let (lower, upper) = (lower?, upper?);
    let [Some(first), Some(last)] = limits else {
        return None;
    };
    if lower.to_f64(&[]) >= upper.to_f64(&[]) {
        if scope.allowed().odd_limits {
            return Some(None);
        }
        let mistake = match row.mount {
            Some(_) => mistake::limits_of_a_file_swapped(),
            None => mistake::limits_swapped(),
        };
        scope.error(first.place.to(last.place), mistake);
        return None;
    }
    Some(Some([lower, upper]))
}

/// One limit, a number.
fn limit(limit: &Expr, row: &description::Row, scope: &mut Scope) -> Option<Value> {
    let value = scope.value(limit)?;
    if !value.is_number() {
        scope.error(limit.place, mistake::limit_with_field());
        return None;
    }
    if let Some(mistake) = many_turns(&value, row) {
        scope.error(limit.place, mistake);
        return None;
    }
    Some(value)
}

/// What is wrong with a position of the row's joint that was hardly meant in rad.
pub(super) fn many_turns(value: &Value, row: &description::Row) -> Option<Mistake> {
    let is_angle = row.joint_type == Some(JointType::Revolute);
    let size = value.as_rational()?.to_f64().value().abs();
    (is_angle && size > MANY_TURNS).then(|| match row.mount {
        // Rows of URDF are mounted anywhere.
        Some(_) => mistake::limit_in_degrees(size),
        None => mistake::position_of_many_turns(size),
    })
}
