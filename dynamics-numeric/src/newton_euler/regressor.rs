//! Torques as a linear function of the links' mass properties.
//!
//! Source: C. G. Atkeson, C. H. An, J. M. Hollerbach, *Estimation of inertial parameters of manipulator
//! loads and links*, Int. J. Robotics Research 5 (1986), 101-119: Newton-Euler is linear in a link's mass,
//! its first moments and its inertia about the origin of its frame.

use dynamics_runtime::Size;
use dynamics_runtime::internal::geometry::{Joint, Pose};
use nalgebra::Matrix3;

use super::inertia::Inertia;
use super::recursion::FrameMotion;
use super::{NumericArm, Placed};

impl Inertia {
    /// The inertia of a body with one of the standard parameters, which is 1: `S = tr(J)/2 1 - J`.
    pub(super) fn unit(parameter: usize) -> Self {
        let mut inertia = Inertia::ZERO;
        let s = &mut inertia.second_moment;
        match parameter {
            0 => inertia.mass = 1.0,
            1..=3 => inertia.first_moment[parameter - 1] = 1.0,
            4..=6 => {
                s.fill_diagonal(0.5);
                s[(parameter - 4, parameter - 4)] = -0.5;
            }
            _ => {
                let (i, j) = [(0, 1), (1, 2), (0, 2)][parameter - 7];
                (s[(i, j)], s[(j, i)]) = (-1.0, -1.0);
            }
        }
        inertia
    }

    /// In the frame where its own is placed, about that frame's origin p: `h' = R h + m p`,
    /// `S' = R S R^T + p (R h)^T + (R h) p^T + m p p^T`.
    pub(super) fn placed(&self, Pose { rotation, position }: &Pose) -> Self {
        let (r, p) = (rotation, position);
        let turned = r * self.first_moment;
        let crossed: Matrix3<f64> = p * turned.transpose();
        Inertia {
            mass: self.mass,
            first_moment: turned + p * self.mass,
            second_moment: r * self.second_moment * r.transpose()
                + crossed
                + crossed.transpose()
                + p * p.transpose() * self.mass,
        }
    }
}

impl<'a, D: Size, V: Size> Placed<'a, '_, D, V> {
    pub(crate) fn standard_regressor(
        &self,
        q: &D::Vector,
        qd: &V::Vector,
        qdd: &V::Vector,
    ) -> D::Each<V::Rows<10>> {
        let joints = self.arm.joints(q);
        let motions = self.motions(&joints, [qd, qdd]);
        self.arm.per_joint(|k| self.arm.block(k, &joints, &motions))
    }

    pub(crate) fn standard_regressor_of_followers(
        &self,
        q: &D::Vector,
        qd: &V::Vector,
        qdd: &V::Vector,
    ) -> impl Iterator<Item = V::Rows<10>> + use<'a, D, V> {
        let (arm, joints) = (self.arm, self.arm.joints(q));
        let motions = self.motions(&joints, [qd, qdd]);
        let followers = (0..arm.count).filter(|k| arm.links[*k].is_follower);
        followers.map(move |k| arm.block(k, &joints, &motions))
    }

    /// The block of the base's own body. The rows of joints are zero.
    pub(crate) fn standard_regressor_of_base(
        &self,
        qd: &V::Vector,
        qdd: &V::Vector,
    ) -> V::Rows<10> {
        let mut block = self.arm.freedoms.rows();
        let motion = self.arm.motion_of_base([qd, qdd], &self.base.gravity);
        for parameter in 0..10 {
            let inertia = Inertia::unit(parameter);
            let wrench = inertia.wrench(&motion.linear_acceleration, &motion.spread);
            let entries = wrench.entries().into_iter().enumerate();
            entries.for_each(|(i, entry)| block[(i, parameter)] = entry);
        }
        block
    }

    /// How the link frames move.
    fn motions(&self, joints: &D::Links<Joint>, motion: [&V::Vector; 2]) -> D::Links<FrameMotion> {
        let base = self.arm.motion_of_base(motion, &self.base.gravity);
        let mut motions = self.arm.per_link(base);
        self.arm.move_frames(joints, motion, base, |place, motion| {
            motions[place.k] = *motion;
        });
        motions
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// The columns of a link's parameters.
    fn block(
        &self,
        k: usize,
        joints: &D::Links<Joint>,
        motions: &D::Links<FrameMotion>,
    ) -> V::Rows<10> {
        let mut block = self.freedoms.rows();
        for parameter in 0..10 {
            let inertia = Inertia::unit(parameter).placed(&self.links[k].table_frame);
            let FrameMotion {
                linear_acceleration,
                spread,
                ..
            } = &motions[k];
            let mut wrench = inertia.wrench(linear_acceleration, spread);
            self.walk_to_base(k, |place| {
                let along = wrench.along_joint(place.link.joint_type);
                block[(place.joint, parameter)] += place.factor * along;
                wrench = wrench.inward(&joints[place.k]);
            });
            if self.floats() {
                let of_base = wrench.entries().into_iter().enumerate();
                of_base.for_each(|(i, entry)| block[(i, parameter)] = entry);
            }
        }
        block
    }
}

#[cfg(test)]
mod tests {
    use dynamics_runtime::{Convention, State};
    use nalgebra::SVector;
    use tables::{mounted_table, random_state};

    use crate::NewtonEuler;

    /// On arms with joints of both kinds, no zero cell and a tool, in both conventions.
    #[test]
    fn the_regressor_times_the_parameters_is_the_torque() {
        for seed in 0..20 {
            let convention = [Convention::Standard, Convention::Modified][seed as usize % 2];
            let table = mounted_table::<4>(convention, seed);
            let arm = NewtonEuler::new(&table);
            let State { q, qd, qdd } = random_state(seed);
            let blocks = arm.standard_regressor(&q, &qd, &qdd);
            let terms = blocks.iter().zip(table.standard_parameters());
            let links = terms.fold(SVector::zeros(), |sum, (y, x)| sum + y * x);
            let motors = SVector::from_fn(|i, _| table.rows[i].reflected_inertia() * qdd[i]);
            let tau = links + motors + arm.friction_vector(&qd) + arm.spring_vector(&q);
            let expected = arm.inverse_dynamics(&q, &qd, &qdd);
            let error = (tau - expected).amax() / expected.amax();
            assert!(error < 1e-13, "{seed}: {error:e}");
        }
    }
}
