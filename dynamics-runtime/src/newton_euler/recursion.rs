//! The outward and the inward iteration.

use nalgebra::{SVector, Vector3};

use super::NewtonEuler;
use super::link::{Link, Pose};
use crate::JointType;

/// Velocities and accelerations of a link frame, in that frame.
#[derive(Clone, Copy)]
struct Motion {
    angular_velocity: Vector3<f64>,
    angular_acceleration: Vector3<f64>,
    linear_acceleration: Vector3<f64>,
}

impl Motion {
    /// A base at rest. Gravity acts on the links as an acceleration of the base against it.
    fn base(gravity: &Vector3<f64>) -> Self {
        Motion {
            angular_velocity: Vector3::zeros(),
            angular_acceleration: Vector3::zeros(),
            linear_acceleration: -gravity,
        }
    }

    /// Craig (6.31) to (6.35): from link i to link i+1.
    fn outward(&self, joint_type: JointType, pose: &Pose, qd: f64, qdd: f64) -> Motion {
        let turn = pose.rotation.transpose();
        let carried = Motion {
            angular_velocity: turn * self.angular_velocity,
            angular_acceleration: turn * self.angular_acceleration,
            linear_acceleration: turn * self.acceleration_of(&pose.position),
        };
        let z = Vector3::z();
        match joint_type {
            JointType::Revolute => Motion {
                angular_velocity: carried.angular_velocity + qd * z,
                angular_acceleration: carried.angular_acceleration
                    + carried.angular_velocity.cross(&(qd * z))
                    + qdd * z,
                ..carried
            },
            JointType::Prismatic => Motion {
                linear_acceleration: carried.linear_acceleration
                    + 2.0 * carried.angular_velocity.cross(&(qd * z))
                    + qdd * z,
                ..carried
            },
        }
    }

    /// Craig (6.36): acceleration of a point fixed in the frame, wd x p + w x (w x p) + vd.
    fn acceleration_of(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.angular_acceleration.cross(point)
            + self
                .angular_velocity
                .cross(&self.angular_velocity.cross(point))
            + self.linear_acceleration
    }
}

/// A force and a moment about the frame's origin.
#[derive(Clone, Copy)]
struct Wrench {
    force: Vector3<f64>,
    moment: Vector3<f64>,
}

impl Wrench {
    fn zero() -> Self {
        Wrench {
            force: Vector3::zeros(),
            moment: Vector3::zeros(),
        }
    }

    /// What moves the link: F = m vd_c, N = I wd + w x I w (Craig (6.37)), moved to the origin.
    fn inertial(link: &Link, motion: &Motion) -> Self {
        let force = link.mass * motion.acceleration_of(&link.com);
        let spin = link.inertia * motion.angular_velocity;
        let moment =
            link.inertia * motion.angular_acceleration + motion.angular_velocity.cross(&spin);
        Wrench {
            force,
            moment: moment + link.com.cross(&force),
        }
    }

    /// f_i = F_i + R f_{i+1}, n_i = N_i + R n_{i+1} + p_c x F_i + p_{i+1} x R f_{i+1}.
    fn inward(&self, outer: &Wrench, pose: &Pose) -> Wrench {
        let force = pose.rotation * outer.force;
        let moment = pose.rotation * outer.moment + pose.position.cross(&force);
        Wrench {
            force: self.force + force,
            moment: self.moment + moment,
        }
    }

    /// The component that the joint's motor supplies.
    fn along_joint(&self, joint_type: JointType) -> f64 {
        match joint_type {
            JointType::Revolute => self.moment.z,
            JointType::Prismatic => self.force.z,
        }
    }
}

impl<const N: usize> NewtonEuler<N> {
    /// Joint torques of a motion under a gravity of any strength, without friction.
    pub(super) fn recursion(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
        gravity: &Vector3<f64>,
    ) -> SVector<f64, N> {
        let poses = self.joint_poses(q);
        let mut wrenches = [Wrench::zero(); N];
        let mut motion = Motion::base(gravity);
        for (i, link) in self.links.iter().enumerate() {
            motion = motion.outward(link.joint_type, &poses[i], qd[i], qdd[i]);
            wrenches[i] = Wrench::inertial(link, &motion);
        }

        let mut tau = SVector::zeros();
        let mut outer = Wrench::zero();
        for (i, link) in self.links.iter().enumerate().rev() {
            let wrench = match poses.get(i + 1) {
                Some(pose) => wrenches[i].inward(&outer, pose),
                None => wrenches[i],
            };
            tau[i] = wrench.along_joint(link.joint_type) + link.reflected_inertia * qdd[i];
            outer = wrench;
        }
        tau
    }
}
