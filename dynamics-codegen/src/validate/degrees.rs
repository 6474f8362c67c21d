//! Angles that were meant in degrees.

use dynamics_symbolic::exact::Rational;

use super::scope::Scope;
use crate::description::{Expr, ExprKind};
use crate::mistake::joint as mistake;

/// Refuses an angle that is a number as nobody writes it in radians: a multiple of 15 that is no less
/// than 30. Every other way of writing it is taken as it stands.
pub(super) fn report_degrees(expr: &Expr, scope: &Scope) {
    let number = match &expr.kind {
        ExprKind::Minus(value) => &value.kind,
        kind => kind,
    };
    let ExprKind::Number(number) = number else {
        return;
    };
    let is_degrees = (30..=360)
        .step_by(15)
        .any(|degrees| *number == Rational::from(degrees));
    if is_degrees {
        scope.error(expr.place, mistake::angle_in_degrees(number));
    }
}
