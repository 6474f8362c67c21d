//! Friction, from its definition.
//!
//!   F = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), C that of the direction
//!
//! The sign s and the exponential are symbols. (s^2 + s)/2 is 1 for positive velocities and 0 for others,
//! (s^2 - s)/2 the same for negative ones.

use super::super::assignment::{Assignment, HALF, Number};
use super::super::dual::Dual;
use super::pose::Lift;
use crate::exact::Rational;
use crate::robot::{self, Interpretation};

/// The cells of a row that say of friction.
pub(super) struct Friction {
    viscous: Number,
    positive: Number,
    negative: Number,
    stribeck: Option<Stribeck>,
}

struct Stribeck {
    /// S
    friction: Number,
    /// 1/v^2
    inverse_square: Number,
}

/// A velocity, and the symbols that are functions of it.
pub(super) struct Velocity<R> {
    pub(super) qd: R,
    pub(super) sign: Number,
    pub(super) exponential: R,
}

impl Friction {
    pub(super) fn new(point: &mut Assignment, row: &robot::Row) -> Self {
        let [positive, negative] = row.coulomb.each_ref().map(|cell| point.cell(cell));
        let one = Interpretation::rational(point, &Rational::ONE);
        Friction {
            viscous: point.cell(&row.viscous),
            positive,
            negative,
            stribeck: row.stribeck.as_ref().map(|stribeck| {
                let v = point.cell(&stribeck.velocity);
                Stribeck {
                    friction: point.cell(&stribeck.friction),
                    inverse_square: point.quotient(one, v * v),
                }
            }),
        }
    }

    /// F
    pub(super) fn force<R: Lift>(&self, at: &Velocity<R>) -> R {
        let square = at.sign * at.sign;
        let (forwards, backwards) = (HALF * (square + at.sign), HALF * (square - at.sign));
        let forwards = self.magnitude(self.positive, at) * R::lift(forwards);
        let backwards = self.magnitude(self.negative, at) * R::lift(backwards);
        R::lift(self.viscous) * at.qd + forwards - backwards
    }

    /// C + (S - C) exp(-(qd/v)^2)
    fn magnitude<R: Lift>(&self, coulomb: Number, at: &Velocity<R>) -> R {
        let more = match &self.stribeck {
            Some(stribeck) => R::lift(stribeck.friction - coulomb) * at.exponential,
            None => R::lift(Number::ZERO),
        };
        R::lift(coulomb) + more
    }

    /// The first and the second derivative of F along a motion, where the sign does not change. Two dual
    /// numbers are two steps in time: x + x' e_1 + x' e_2 + x'' e_1 e_2.
    pub(super) fn rates(
        &self,
        at: &Velocity<Number>,
        [qdd, jerk]: [Number; 2],
    ) -> (Number, Number) {
        let stribeck = self.stribeck.as_ref();
        let inverse_square = stribeck.map_or(Number::ZERO, |stribeck| stribeck.inverse_square);
        let (qd, x) = (at.qd, at.exponential);
        // x = exp(-(qd/v)^2): x' = -2 qd qdd / v^2 x, and x'' by the product rule.
        let slope = -(inverse_square + inverse_square);
        let first = slope * qd * qdd * x;
        let second = slope * (qdd * qdd + qd * jerk) * x + slope * qd * qdd * first;
        let moving = Velocity {
            qd: Dual::new(Dual::new(qd, qdd), Dual::new(qdd, jerk)),
            sign: at.sign,
            exponential: Dual::new(Dual::new(x, first), Dual::new(first, second)),
        };
        let force = self.force(&moving);
        (force.derivative.value, force.derivative.derivative)
    }
}
