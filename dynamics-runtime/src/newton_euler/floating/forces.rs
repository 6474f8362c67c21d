//! The terms of `tau = M a + V + G + K + F`, and inverse dynamics.

use nalgebra::Vector3;

use super::{NumericFloating, twist};
use crate::Pose;
use crate::newton_euler::composite::Moments;
use crate::newton_euler::inertia::Wrench;
use crate::newton_euler::joint::Joint;
use crate::newton_euler::recursion::FrameMotion;
use crate::size::Size;

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// Mass matrix M(q), V x V, both triangles: column j is the force of a unit acceleration j, at rest and without gravity.
    /// It holds no coordinate of the base. Reflected inertias are on the diagonal.
    pub fn mass_matrix(&self, q: &D::Vector) -> V::Matrix {
        self.arm.at(q, |joints| self.mass_matrix_of(joints))
    }

    /// Coriolis and centrifugal forces V(q, v): no acceleration, no gravity. It holds no coordinate of the base.
    pub fn coriolis_vector(&self, q: &D::Vector, v: &V::Vector) -> V::Vector {
        self.arm.at(q, |joints| self.velocity_forces(joints, v))
    }

    /// Gravity forces G: no velocity, no acceleration, no springs. Six of them hold the weight of the robot.
    pub fn gravity_vector(&self, base: &Pose<f64>, q: &D::Vector) -> V::Vector {
        let gravity = self.gravity(base);
        self.arm.at(q, |joints| self.weights(joints, &gravity))
    }

    /// Friction forces F(v), as those of an arm; six zeros before them.
    pub fn friction_vector(&self, v: &V::Vector) -> V::Vector {
        self.arm.gathered(|place| place.link.friction(place.of(v)))
    }

    /// Spring forces K(q), as those of an arm; six zeros before them.
    pub fn spring_vector(&self, q: &D::Vector) -> V::Vector {
        self.arm
            .gathered(|place| place.link.spring.force(place.position(q)))
    }

    /// Forces of a motion, M a + V + G + K + F.
    pub fn inverse_dynamics(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        a: &V::Vector,
    ) -> V::Vector {
        let gravity = self.gravity(base);
        let forces = self
            .arm
            .at(q, |joints| self.forces(joints, [v, a], &gravity));
        forces + self.arm.joint_forces(q, v)
    }

    /// Forces without acceleration, V + G + K + F.
    pub fn bias_force(&self, base: &Pose<f64>, q: &D::Vector, v: &V::Vector) -> V::Vector {
        self.inverse_dynamics(base, q, v, &self.arm.freedoms.vector())
    }
}

/// The same where the joints are so.
impl<D: Size, V: Size> NumericFloating<D, V> {
    /// M by composite bodies: all links and the base as one body resist its acceleration.
    pub(super) fn mass_matrix_of(&self, joints: &D::Links<Joint>) -> V::Matrix {
        let (mut mass_matrix, links) = self.arm.composites(joints);
        let own = self.body.inertia;
        let whole = links.map_or(own, |links| links + own).matrix();
        for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
            mass_matrix[(i, j)] = whole[(i, j)];
        }
        mass_matrix
    }

    /// M a + V + G under a gravity in the axes of the base.
    pub(super) fn forces(
        &self,
        joints: &D::Links<Joint>,
        [v, a]: [&V::Vector; 2],
        gravity: &Vector3<f64>,
    ) -> V::Vector {
        let base = FrameMotion::moving(&twist::<V>(v), &twist::<V>(a), gravity);
        let inertia = &self.body.inertia;
        let own = inertia.wrench(&base.linear_acceleration, &base.spread);
        let (mut forces, links) = self.arm.forces(joints, [v, a], base);
        let wrench = links.map_or(own, |links| links + own);
        set(&wrench, |i, entry| forces[i] = entry);
        forces
    }

    /// V.
    pub(super) fn velocity_forces(&self, joints: &D::Links<Joint>, v: &V::Vector) -> V::Vector {
        self.forces(joints, [v, &self.arm.freedoms.vector()], &Vector3::zeros())
    }

    /// G under a gravity in the axes of the base. The weight of all bodies acts at their centre of mass: `f = -m g`,
    /// `n = -h x g`.
    pub(super) fn weights(&self, joints: &D::Links<Joint>, gravity: &Vector3<f64>) -> V::Vector {
        let (mut forces, links) = self.arm.weights_under(joints, gravity);
        let own = Moments {
            mass: self.body.mass,
            first: self.body.inertia.first_moment,
        };
        let Moments { mass, first } = links.map_or(own, |links| links + own);
        let weight = Wrench {
            force: gravity * -mass,
            moment: gravity.cross(&first),
        };
        set(&weight, |i, entry| forces[i] = entry);
        forces
    }
}

/// Sets the six numbers of the base.
fn set(wrench: &Wrench, entry: impl FnMut(usize, f64)) {
    let mut entry = entry;
    let entries = wrench.entries().into_iter().enumerate();
    entries.for_each(|(i, number)| entry(i, number));
}
