//! Positions of joints and poses of frames, over the field or over dual numbers.

use super::super::assignment::Number;
use super::super::dual::Dual;
use crate::linear::{Matrix3, Ring, Vector3};

/// A ring that the table's numbers are part of.
pub(super) trait Lift: Ring {
    /// The number in this ring.
    fn lift(x: Number) -> Self;
}

impl Lift for Number {
    fn lift(x: Number) -> Self {
        x
    }
}

impl<R: Lift> Lift for Dual<R> {
    fn lift(x: Number) -> Self {
        Dual::new(R::lift(x), R::lift(Number::ZERO))
    }
}

/// The position of a joint: sine and cosine of an angle, or a displacement.
#[derive(Clone, Copy)]
pub(super) struct Position<R> {
    pub(super) s: R,
    pub(super) c: R,
    pub(super) q: R,
}

impl Position<Number> {
    pub(super) fn at((s, c): (Number, Number), q: Number) -> Self {
        Position { s, c, q }
    }
}

impl<R: Ring> Position<R> {
    /// q itself.
    pub(super) fn value(&self) -> R {
        self.q
    }

    /// The position with its derivative where q changes at the rate `rate`.
    pub(super) fn moving(self, rate: R) -> Position<Dual<R>> {
        Position {
            s: Dual::new(self.s, self.c * rate),
            c: Dual::new(self.c, -(self.s * rate)),
            q: Dual::new(self.q, rate),
        }
    }
}

/// A homogeneous transform.
#[derive(Clone, Copy)]
pub(super) struct Pose<R> {
    pub(super) rotation: Matrix3<R>,
    pub(super) origin: Vector3<R>,
}

impl<R: Lift> Pose<R> {
    /// A frame that is the other frame.
    pub(super) fn identity() -> Self {
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        Pose::screw_x((zero, one), zero)
    }

    /// Rz(angle) Tz(d)
    pub(super) fn screw_z((s, c): (R, R), d: R) -> Self {
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        Pose {
            rotation: Matrix3([[c, -s, zero], [s, c, zero], [zero, zero, one]]),
            origin: Vector3::new(zero, zero, d),
        }
    }

    /// Rx(angle) Tx(a)
    pub(super) fn screw_x((s, c): (R, R), a: R) -> Self {
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        Pose {
            rotation: Matrix3([[one, zero, zero], [zero, c, -s], [zero, s, c]]),
            origin: Vector3::new(a, zero, zero),
        }
    }

    /// The frame that `next` describes in this one.
    pub(super) fn then(&self, next: &Pose<R>) -> Pose<R> {
        Pose {
            rotation: self.rotation.product(&next.rotation),
            origin: self.rotation.apply(next.origin) + self.origin,
        }
    }
}
