//! Inverse dynamics by the outward and the inward iteration.

use dynamics_runtime::internal::geometry::{Joint, cross, times};
use dynamics_runtime::{JointType, Size};
use nalgebra::{Matrix3, Vector3};

use super::NumericArm;
use super::base::twist;
use super::inertia::Wrench;
use super::walk::Place;

/// Velocities and accelerations of a link frame, in that frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct FrameMotion {
    angular_velocity: Vector3<f64>,
    angular_acceleration: Vector3<f64>,
    /// The acceleration of the frame's origin, gravity taken off.
    pub(super) linear_acceleration: Vector3<f64>,
    /// U: a point r fixed in the frame has the acceleration `linear_acceleration + U r`.
    pub(super) spread: Matrix3<f64>,
}

impl FrameMotion {
    /// A base at rest. Gravity acts on the links as an acceleration of the base against it.
    fn base(gravity: &Vector3<f64>) -> Self {
        FrameMotion {
            angular_velocity: Vector3::zeros(),
            angular_acceleration: Vector3::zeros(),
            linear_acceleration: -gravity,
            spread: Matrix3::zeros(),
        }
    }

    /// A base that moves with the twist (v, w) and its rate, in its own axes: `a = dv/dt + w x v - g`.
    fn moving([[v, w], [vd, wd]]: [[Vector3<f64>; 2]; 2], gravity: &Vector3<f64>) -> Self {
        FrameMotion {
            angular_velocity: w,
            angular_acceleration: wd,
            linear_acceleration: vd + w.cross(&v) - gravity,
            spread: spread(&w, &wd),
        }
    }

    /// Craig (6.31) to (6.35): from link i to link i+1.
    #[inline(always)]
    fn outward(&self, joint_type: JointType, joint: &Joint, qd: f64, qdd: f64) -> FrameMotion {
        let mut angular_velocity = joint.outward(&self.angular_velocity);
        let mut angular_acceleration = joint.outward(&self.angular_acceleration);
        let of_origin = times(&self.spread, &joint.origin, &self.linear_acceleration);
        let mut linear_acceleration = joint.outward(&of_origin);
        // w x (qd z), the carried w.
        let (x, y) = (qd * angular_velocity.y, -qd * angular_velocity.x);
        match joint_type {
            JointType::Revolute => {
                angular_acceleration += Vector3::new(x, y, qdd);
                angular_velocity.z += qd;
            }
            JointType::Prismatic => linear_acceleration += Vector3::new(2.0 * x, 2.0 * y, qdd),
        }
        FrameMotion {
            angular_velocity,
            angular_acceleration,
            linear_acceleration,
            spread: spread(&angular_velocity, &angular_acceleration),
        }
    }
}

/// U of Craig (6.36), `wd x r + w x (w x r) = U r`: `U = [wd]x + w w^T - (w.w) 1`.
#[inline(always)]
fn spread(w: &Vector3<f64>, wd: &Vector3<f64>) -> Matrix3<f64> {
    let (xx, yy, zz) = (w.x * w.x, w.y * w.y, w.z * w.z);
    let (xy, yz, xz) = (w.x * w.y, w.y * w.z, w.x * w.z);
    #[rustfmt::skip]
    let spread = Matrix3::new(
        -(yy + zz), xy - wd.z,  xz + wd.y,
        xy + wd.z,  -(xx + zz), yz - wd.x,
        xz - wd.y,  yz + wd.x,  -(xx + yy),
    );
    spread
}

impl Wrench {
    /// The component that the joint's motor supplies.
    #[inline(always)]
    pub(super) fn along_joint(&self, joint_type: JointType) -> f64 {
        match joint_type {
            JointType::Revolute => self.moment.z,
            JointType::Prismatic => self.force.z,
        }
    }

    /// The wrench on frame i, in frame i-1 and about its origin: `R f` and `R n + p x R f`.
    #[inline(always)]
    pub(super) fn inward(&self, joint: &Joint) -> Wrench {
        let force = joint.inward(&self.force);
        Wrench {
            force,
            moment: cross(&joint.origin, &force, &joint.inward(&self.moment)),
        }
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// Joint torques of a motion under a gravity in the axes of the base, without springs and friction; before them the wrench
    /// that a base that moves needs.
    #[inline(always)]
    pub(super) fn forces(
        &self,
        joints: &D::Links<Joint>,
        [qd, qdd]: [&V::Vector; 2],
        gravity: &Vector3<f64>,
    ) -> V::Vector {
        let base = self.motion_of_base([qd, qdd], gravity);
        let mut wrenches = self.per_link(Wrench::ZERO);
        self.move_frames(
            joints,
            [qd, qdd],
            base,
            #[inline(always)]
            |Place { k, link, .. }, motion| {
                let inertia = &link.solid.inertia;
                wrenches[k] = inertia.wrench(&motion.linear_acceleration, &motion.spread);
            },
        );
        // f_i = F_i + R f_{i+1}, n_i = N_i + R n_{i+1} + p_{i+1} x R f_{i+1}.
        let mut tau = self.freedoms.vector();
        let of_links = self.inward(
            #[inline(always)]
            |place| wrenches[place.k],
            #[inline(always)]
            |place, wrench| {
                let link = place.link;
                let motor = link.reflected_inertia * place.of(qdd);
                place.add(&mut tau, wrench.along_joint(link.joint_type) + motor);
                place.hand_on(|| wrench.inward(&joints[place.k]))
            },
        );
        if let Some(body) = self.body() {
            let own = (body.solid.inertia).wrench(&base.linear_acceleration, &base.spread);
            of_links.map_or(own, |links| links + own).set(&mut tau);
        }
        tau
    }

    /// V.
    #[inline(always)]
    pub(super) fn velocity_forces(&self, joints: &D::Links<Joint>, qd: &V::Vector) -> V::Vector {
        self.forces(joints, [qd, &self.freedoms.vector()], &Vector3::zeros())
    }

    /// How the base moves against gravity.
    #[inline(always)]
    pub(super) fn motion_of_base(
        &self,
        motion: [&V::Vector; 2],
        gravity: &Vector3<f64>,
    ) -> FrameMotion {
        if self.floats() {
            FrameMotion::moving(motion.map(twist), gravity)
        } else {
            FrameMotion::base(gravity)
        }
    }

    /// How the link frames move, from the base outwards.
    #[inline(always)]
    pub(super) fn move_frames(
        &self,
        joints: &D::Links<Joint>,
        [qd, qdd]: [&V::Vector; 2],
        base: FrameMotion,
        mut visit: impl FnMut(Place<'_>, &FrameMotion),
    ) {
        self.outward(
            base,
            #[inline(always)]
            |place, motion| {
                let (qd, qdd) = (place.of(qd), place.of(qdd));
                let motion = motion.outward(place.link.joint_type, &joints[place.k], qd, qdd);
                visit(place, &motion);
                motion
            },
        );
    }
}
