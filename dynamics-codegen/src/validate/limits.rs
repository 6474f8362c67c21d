//! The range of a joint.

use dynamics_symbolic::robot::{JointType, Value};

use super::known::all;
use super::scope::Scope;
use crate::description::{self, Expr, Given};
use crate::mistake::joint as mistake;
use crate::place::Place;

/// A revolute joint does not turn so far, in rad, unless its position is written in terms of PI: five
/// turns.
const MANY_TURNS: f64 = 10.0 * core::f64::consts::PI;

/// Both limits. Outer `None`: in error; inner `None`: not written. A file's limits that make no sense may be none.
pub(super) fn limits(row: &description::Row, scope: &mut Scope) -> Option<Option<[Value; 2]>> {
    row.limits.read(None, |limits| {
        if row.limits_of_file
            && let Some((place, size)) = many_turns_of_either(limits, row, scope)
        {
            if scope.allowed().odd_limits {
                return Some(None);
            }
            return scope.refused(place, mistake::limit_in_degrees(size));
        }
        let value = |limit: &Option<Expr>| self::limit(limit.as_ref()?, row, scope);
        let [lower, upper] = all(limits.each_ref().map(value))?;
        let [Some(first), Some(last)] = limits else {
            return None;
        };
        if lower.to_f64(&[]) < upper.to_f64(&[]) {
            return Some(Some([lower, upper]));
        }
        if scope.allowed().odd_limits {
            return Some(None);
        }
        let mistake = if row.limits_of_file {
            mistake::limits_of_a_file_swapped()
        } else {
            mistake::limits_swapped()
        };
        scope.refused(first.place.to(last.place), mistake)
    })
}

/// One limit, a number.
fn limit(limit: &Expr, row: &description::Row, scope: &mut Scope) -> Option<Value> {
    let value = scope.value(limit)?;
    if !value.is_number() {
        return scope.refused(limit.place, mistake::limit_with_field());
    }
    match many_turns(&value, row) {
        Some(size) => scope.refused(limit.place, mistake::position_of_many_turns(size)),
        None => Some(value),
    }
}

/// The larger of two limits that were hardly meant in rad.
fn many_turns_of_either(
    limits: &[Option<Expr>; 2],
    row: &description::Row,
    scope: &mut Scope,
) -> Option<(Place, f64)> {
    let sizes = limits.iter().flatten().filter_map(|limit| {
        let value = scope.value(limit)?;
        Some((limit.place, many_turns(&value, row)?))
    });
    sizes.max_by(|(_, one), (_, other)| one.total_cmp(other))
}

/// The greatest torque or speed, a number. Outer `None`: in error; inner `None`: not written.
pub(super) fn greatest(cell: &Given<Expr>, scope: &mut Scope) -> Option<Option<Value>> {
    cell.read(None, |expr| {
        let value = scope.value(expr)?;
        if !value.is_number() {
            return scope.refused(expr.place, mistake::limit_with_field());
        }
        if value.to_f64(&[]) <= 0.0 {
            return scope.refused(expr.place, mistake::limit_not_positive());
        }
        Some(Some(value))
    })
}

/// The size of a position of the row's joint that was hardly meant in rad.
pub(super) fn many_turns(value: &Value, row: &description::Row) -> Option<f64> {
    let is_angle = row.joint_type == Some(JointType::Revolute);
    let size = value.as_rational()?.to_f64().value().abs();
    (is_angle && size > MANY_TURNS).then_some(size)
}
