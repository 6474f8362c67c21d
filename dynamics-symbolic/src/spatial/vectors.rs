//! Spatial vectors: motions and forces.

use crate::linear::{Ring, Vector3};
use core::ops::{Add, Mul};

/// The motion that a joint's axis, the z axis of its frame, lets the link have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisMotion {
    /// The link turns about the axis.
    Turns,
    /// The link slides along the axis.
    Slides,
}

/// A spatial motion vector, a twist: a velocity of a link, say, or an acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<R> {
    /// Angular.
    pub w: Vector3<R>,
    /// Linear, at the frame's origin.
    pub v: Vector3<R>,
}

/// A spatial force vector, a wrench; momenta are of this kind too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Force<R> {
    /// Moment about the frame's origin.
    pub n: Vector3<R>,
    /// Force.
    pub f: Vector3<R>,
}

impl<R: Ring> Motion<R> {
    /// The same component six times (for zero).
    pub fn splat(x: R) -> Self {
        Motion {
            w: Vector3::splat(x),
            v: Vector3::splat(x),
        }
    }

    /// S: along z, for the joint itself.
    pub fn axis(axis_motion: AxisMotion, zero: R, one: R) -> Self {
        let (z, none) = (Vector3::new(zero, zero, one), Vector3::splat(zero));
        match axis_motion {
            AxisMotion::Turns => Motion { w: z, v: none },
            AxisMotion::Slides => Motion { w: none, v: z },
        }
    }

    /// With S x added: what the joint does besides.
    pub fn with_joint(mut self, axis_motion: AxisMotion, x: R) -> Self {
        let along = match axis_motion {
            AxisMotion::Turns => &mut self.w.0[2],
            AxisMotion::Slides => &mut self.v.0[2],
        };
        *along = *along + x;
        self
    }

    /// At the point r.
    pub fn at(self, r: Vector3<R>) -> Self {
        Motion {
            v: self.v + self.w.cross(r),
            ..self
        }
    }

    /// In other axes: `turn` says what a vector is in these.
    pub fn turned(self, turn: impl Fn(Vector3<R>) -> Vector3<R>) -> Self {
        Motion {
            w: turn(self.w),
            v: turn(self.v),
        }
    }

    /// Motion cross motion.
    pub fn cross(self, other: Self) -> Self {
        Motion {
            w: self.w.cross(other.w),
            v: self.w.cross(other.v) + self.v.cross(other.w),
        }
    }

    /// Motion cross force.
    pub fn cross_force(self, force: Force<R>) -> Force<R> {
        Force {
            n: self.w.cross(force.n) + self.v.cross(force.f),
            f: self.w.cross(force.f),
        }
    }

    /// Power.
    pub fn dot(self, force: Force<R>) -> R {
        self.w.dot(force.n) + self.v.dot(force.f)
    }
}

impl<R: Ring> Force<R> {
    /// The same component six times (for zero).
    pub fn splat(x: R) -> Self {
        Force {
            n: Vector3::splat(x),
            f: Vector3::splat(x),
        }
    }

    /// The component along z: what the joint itself feels.
    pub fn along(self, axis_motion: AxisMotion) -> R {
        match axis_motion {
            AxisMotion::Turns => self.n[2],
            AxisMotion::Slides => self.f[2],
        }
    }
}

impl<R: Ring> Add for Motion<R> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Motion {
            w: self.w + other.w,
            v: self.v + other.v,
        }
    }
}

impl<R: Ring> Add for Force<R> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Force {
            n: self.n + other.n,
            f: self.f + other.f,
        }
    }
}

impl<R: Ring> Mul<R> for Force<R> {
    type Output = Self;

    fn mul(self, k: R) -> Self {
        Force {
            n: self.n * k,
            f: self.f * k,
        }
    }
}
