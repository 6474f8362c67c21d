//! Numbers of files in expressions.

use dynamics_symbolic::exact::Rational;

use crate::description::{Expr, ExprKind};
use crate::place::Place;

/// A number with its sign apart, as an expression has it.
pub(super) fn signed(value: Rational, place: Place) -> Expr {
    let is_negative = value < Rational::ZERO;
    let number = |value| Expr {
        kind: ExprKind::Number(value),
        place,
    };
    match is_negative {
        true => Expr {
            kind: ExprKind::Minus(Box::new(number(-value))),
            place,
        },
        false => number(value),
    }
}
