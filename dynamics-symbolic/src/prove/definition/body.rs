//! Rigid bodies of the table in the field.

use super::super::assignment::{Assignment, Number};
use super::pose::{Lift, Pose};
use crate::linear::{Symmetric3, Vector3};
use crate::robot;

/// A rigid body in the axes of its frame.
pub(super) struct Body {
    pub(super) mass: Number,
    pub(super) com: Vector3<Number>,
    /// About the centre of mass.
    pub(super) inertia: Symmetric3<Number>,
}

impl Body {
    pub(super) fn new(point: &mut Assignment, body: &robot::Body) -> Self {
        let inertia = body.inertia.each_ref().map(|entry| point.cell(entry));
        Body {
            mass: point.cell(&body.mass),
            com: Vector3(body.com.each_ref().map(|x| point.cell(x))),
            inertia: Symmetric3::from_entries(inertia),
        }
    }

    /// The centre of mass where the body's frame is at `pose`.
    pub(super) fn center<R: Lift>(&self, pose: &Pose<R>) -> Vector3<R> {
        pose.rotation.apply(Vector3(self.com.0.map(R::lift))) + pose.origin
    }

    /// The inertia tensor about the centre of mass, in the body's axes.
    pub(super) fn tensor<R: Lift>(&self) -> Symmetric3<R> {
        self.inertia.map(R::lift)
    }

    /// The parameters, without a motor, about the origin of the frame in which the body's own frame is at `pose`:
    /// J = I + m (c.c 1 - c c^T), h = m c.
    pub(super) fn parameters(&self, pose: &Pose<Number>) -> [Number; 11] {
        let (m, center) = (self.mass, self.center(pose));
        let [x, y, z] = center.0;
        let [hx, hy, hz] = (center * m).0;
        let own = self.inertia.rotated(&pose.rotation);
        [
            own.xx + hy * y + hz * z,
            own.xy - hx * y,
            own.xz - hx * z,
            own.yy + hx * x + hz * z,
            own.yz - hy * z,
            own.zz + hx * x + hy * y,
            hx,
            hy,
            hz,
            m,
            Number::ZERO,
        ]
    }
}
