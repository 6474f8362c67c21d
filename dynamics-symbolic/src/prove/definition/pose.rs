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
    /// The position with its derivative if q changes at the rate `rate`.
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

    /// T(xyz) Rz(yaw) Ry(pitch) Rx(roll), by sines and cosines of roll, pitch and yaw.
    pub(super) fn placed(xyz: [R; 3], [roll, (sp, cp), yaw]: [(R, R); 3]) -> Self {
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        let pitch = Matrix3([[cp, zero, sp], [zero, one, zero], [-sp, zero, cp]]);
        let yaw = Pose::screw_z(yaw, zero).rotation;
        let roll = Pose::screw_x(roll, zero).rotation;
        Pose {
            rotation: yaw.product(&pitch).product(&roll),
            origin: Vector3(xyz),
        }
    }

    /// The frame that `next` describes in this one.
    pub(super) fn then(&self, next: &Pose<R>) -> Pose<R> {
        Pose {
            rotation: self.rotation.product(&next.rotation),
            origin: self.rotation.apply(next.origin) + self.origin,
        }
    }

    /// The frame that a constant transform describes in this one, or this one if there is none.
    pub(super) fn then_fixed(&self, next: &Option<Pose<Number>>) -> Pose<R> {
        match next {
            Some(Pose { rotation, origin }) => self.then(&Pose {
                rotation: Matrix3(rotation.0.map(|row| row.map(R::lift))),
                origin: Vector3(origin.0.map(R::lift)),
            }),
            None => *self,
        }
    }

    /// The other frame in this one: R^T, -R^T p.
    pub(super) fn inverse(&self) -> Pose<R> {
        let rotation = self.rotation.transpose();
        Pose {
            rotation,
            origin: -rotation.apply(self.origin),
        }
    }
}

/// The velocities of a frame whose pose has a derivative.
impl<R: Lift> Pose<Dual<R>> {
    /// The angular velocity in the frame's own axes: w of [w]x = R^T R'.
    pub(super) fn angular_velocity(&self) -> Vector3<R> {
        let rate = Matrix3(self.rotation.0.map(|row| row.map(|x| x.derivative)));
        let axes = self.axes();
        let entry = |i: usize, j: usize| axes.column(i).dot(rate.column(j));
        Vector3::new(entry(2, 1), entry(0, 2), entry(1, 0))
    }

    /// The velocity of the origin in the world.
    pub(super) fn velocity(&self) -> Vector3<R> {
        Vector3(self.origin.0.map(|x| x.derivative))
    }

    /// The rotation without its derivative.
    pub(super) fn axes(&self) -> Matrix3<R> {
        Matrix3(self.rotation.0.map(|row| row.map(|x| x.value)))
    }
}
