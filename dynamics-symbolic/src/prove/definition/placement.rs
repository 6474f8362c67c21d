//! Where the base and the tool are, in the field.

use super::super::assignment::{Assignment, Number};
use super::body::Body;
use super::pose::{Lift, Pose};
use crate::linear::{Matrix3, Vector3};
use crate::robot;

/// A frame in another one.
pub(super) struct Placement {
    xyz: Vector3<Number>,
    /// Sine and cosine of roll, pitch and yaw.
    rpy: [(Number, Number); 3],
}

/// The tool frame in the last link frame, and the tool's body.
pub(super) struct Tool {
    pub(super) placement: Placement,
    pub(super) body: Body,
}

impl Placement {
    pub(super) fn new(point: &mut Assignment, placement: &robot::Placement) -> Self {
        Placement {
            xyz: Vector3(placement.xyz.each_ref().map(|x| point.cell(x))),
            rpy: placement.rpy.each_ref().map(|angle| point.angle(angle)),
        }
    }

    /// A rotation by angles whose sines and cosines are known.
    pub(super) fn turned(rpy: [(Number, Number); 3]) -> Self {
        Placement {
            xyz: Vector3::splat(Number::ZERO),
            rpy,
        }
    }

    /// T(xyz) Rz(yaw) Ry(pitch) Rx(roll)
    pub(super) fn pose<R: Lift>(&self) -> Pose<R> {
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        let [(sr, cr), (sp, cp), (sy, cy)] = self.rpy.map(|(s, c)| (R::lift(s), R::lift(c)));
        let roll = Matrix3([[one, zero, zero], [zero, cr, -sr], [zero, sr, cr]]);
        let pitch = Matrix3([[cp, zero, sp], [zero, one, zero], [-sp, zero, cp]]);
        let yaw = Matrix3([[cy, -sy, zero], [sy, cy, zero], [zero, zero, one]]);
        Pose {
            rotation: yaw.product(&pitch).product(&roll),
            origin: Vector3(self.xyz.0.map(R::lift)),
        }
    }
}

impl Tool {
    pub(super) fn new(point: &mut Assignment, tool: &robot::Tool) -> Self {
        Tool {
            placement: Placement::new(point, &tool.placement),
            body: Body::new(point, &tool.mass, &tool.com, &tool.inertia),
        }
    }
}
