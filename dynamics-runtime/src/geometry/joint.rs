//! A joint at a position: how vectors and inertias pass from one link to the next.

use nalgebra::{Matrix3, Vector3};

use super::angle::SinCos;
use super::linear::{difference, sum};
use super::pose::Pose;
use crate::Scalar;

/// Frame i in frame i-1, `Rx(alpha) Tx(a) Rz(theta) Tz(d)` (Craig (3.6)), at one joint position;
/// `Rz(before)` at some place before it where joints between the two frames are locked.
///
/// The rotation stays in its two factors: a vector passes by two turns of a plane, which are 8
/// multiplications and 4 additions, and no matrix has to be made first.
#[derive(Clone, Copy, Debug)]
pub struct Joint {
    before: Option<SinCos>,
    /// The twist of the link before.
    pub alpha: SinCos,
    /// The angle about the axis of the joint.
    pub theta: SinCos,
    /// Origin of frame i in frame i-1: `(a, -d sin(alpha), d cos(alpha))`.
    pub origin: Vector3<f64>,
}

impl Joint {
    /// No joint, whose place another one takes. All zeros: a list of these is written the fastest.
    pub const NONE: Joint = Joint {
        before: None,
        alpha: SinCos { sin: 0.0, cos: 0.0 },
        theta: SinCos { sin: 0.0, cos: 0.0 },
        origin: Vector3::new(0.0, 0.0, 0.0),
    };

    /// A joint of these four parameters.
    #[inline(always)]
    pub fn new(alpha: SinCos, a: f64, theta: SinCos, d: f64) -> Self {
        let origin = Vector3::new(a, -alpha.sin * d, alpha.cos * d);
        Joint {
            before: None,
            alpha,
            theta,
            origin,
        }
    }

    /// `Rx(alpha) Tx(a)`; the two commute.
    pub fn along_x(alpha: SinCos, a: f64) -> Pose {
        Joint::new(alpha, a, SinCos::ZERO, 0.0).pose()
    }

    /// The joint behind a turn about the previous frame's z.
    #[inline]
    pub fn behind(self, before: SinCos) -> Self {
        let (x, y) = turn(before, self.origin.x, self.origin.y);
        Joint {
            before: Some(before),
            origin: Vector3::new(x, y, self.origin.z),
            ..self
        }
    }

    /// The joint displaced by a vector of the previous frame.
    #[inline]
    pub fn at(self, place: &Vector3<f64>) -> Self {
        Joint {
            origin: self.origin + place,
            ..self
        }
    }

    /// The joint moved on by a turn or by a distance along its axis.
    pub fn moved(self, turn: SinCos, distance: f64) -> Self {
        let along = self.inward(&Vector3::z());
        Joint {
            theta: self.theta.plus(turn),
            origin: self.origin + along * distance,
            ..self
        }
    }

    /// The rotation multiplied out.
    pub fn pose(&self) -> Pose {
        let (sa, ca, st, ct) = (
            self.alpha.sin,
            self.alpha.cos,
            self.theta.sin,
            self.theta.cos,
        );
        #[rustfmt::skip]
        let behind = Matrix3::new(
            ct,      -st,      0.0,
            st * ca, ct * ca, -sa,
            st * sa, ct * sa,  ca,
        );
        let rotation = match self.before {
            None => behind,
            Some(before) => Joint::new(SinCos::ZERO, 0.0, before, 0.0).pose().rotation * behind,
        };
        Pose {
            rotation,
            position: self.origin,
        }
    }

    /// A vector of frame i-1 in frame i.
    #[inline(always)]
    pub fn outward(&self, v: &Vector3<f64>) -> Vector3<f64> {
        let (x, y) = match self.before {
            None => (v.x, v.y),
            Some(before) => turn(before.opposite(), v.x, v.y),
        };
        let (y, z) = turn(self.alpha.opposite(), y, v.z);
        let (x, y) = turn(self.theta.opposite(), x, y);
        Vector3::new(x, y, z)
    }

    /// A vector of frame i in frame i-1.
    #[inline(always)]
    pub fn inward(&self, v: &Vector3<f64>) -> Vector3<f64> {
        let (x, y) = turn(self.theta, v.x, v.y);
        let (y, z) = turn(self.alpha, y, v.z);
        let (x, y) = match self.before {
            None => (x, y),
            Some(before) => turn(before, x, y),
        };
        Vector3::new(x, y, z)
    }

    /// `R S R^T` of a symmetric S, one factor of R after the other.
    #[inline(always)]
    pub fn tensor_inward(&self, s: &Matrix3<f64>) -> Matrix3<f64> {
        let (xx, yy, xy) = turn_tensor(self.theta, s.m11, s.m22, s.m12);
        let (xz, yz) = turn(self.theta, s.m13, s.m23);
        let (yy, zz, yz) = turn_tensor(self.alpha, yy, s.m33, yz);
        let (xy, xz) = turn(self.alpha, xy, xz);
        let Some(before) = self.before else {
            return Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        };
        let (xx, yy, xy) = turn_tensor(before, xx, yy, xy);
        let (xz, yz) = turn(before, xz, yz);
        Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
    }
}

/// Turns the vector (u, v) of a plane: (c u - s v, s u + c v).
#[inline(always)]
fn turn(SinCos { sin, cos }: SinCos, u: f64, v: f64) -> (f64, f64) {
    (difference(cos, u, sin, v), sum(sin, u, cos, v))
}

/// Turns the symmetric tensor [uu, uv; uv, vv] of a plane; returns its uu, vv and uv.
///
/// `uu' = c^2 uu - 2 c s uv + s^2 vv = uu - s t` with `t = s (uu - vv) + 2 c uv`, and in the same
/// way `vv' = vv + s t`, `uv' = c t - uv`.
#[inline(always)]
fn turn_tensor(SinCos { sin, cos }: SinCos, uu: f64, vv: f64, uv: f64) -> (f64, f64, f64) {
    let t = Scalar::mul_add(sin, uu - vv, cos * (uv + uv));
    (
        Scalar::mul_add(-sin, t, uu),
        Scalar::mul_add(sin, t, vv),
        Scalar::mul_add(cos, t, -uv),
    )
}
