//! Forces as a linear function of the mass properties of the base and of the links.

use super::{NumericFloating, Place, twist};
use crate::newton_euler::inertia::Inertia;
use crate::newton_euler::recursion::FrameMotion;
use crate::newton_euler::regressor::{StandardParameters, parameters};
use crate::size::Size;
use crate::table::AsArm as _;
use crate::{Pose, Table};

impl<const N: usize> Table<N> {
    /// The ten standard inertial parameters of a base that moves, with those of the bodies that are fixed to it; `None` if it
    /// stands.
    pub fn standard_parameters_of_base(&self) -> Option<StandardParameters> {
        self.arm().base_body().map(|body| parameters(&body))
    }
}

#[cfg(feature = "std")]
impl crate::RuntimeTable {
    /// As [`Table::standard_parameters_of_base`].
    pub fn standard_parameters_of_base(&self) -> Option<StandardParameters> {
        self.arm().base_body().map(|body| parameters(&body))
    }
}

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// The standard regressor of the links of joints that move by themselves, a block V x 10 for each: as
    /// [that of an arm](crate::NumericArm::standard_regressor), the forces without friction, springs and reflected inertias.
    pub fn standard_regressor(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        a: &V::Vector,
    ) -> D::Each<V::Rows<10>> {
        let joints = self.arm.joints(q);
        let motions = self.arm.motions(&joints, [v, a], self.motion(base, v, a));
        self.arm.per_joint(|k| self.arm.block(k, &joints, &motions))
    }

    /// The blocks of links whose joints follow others.
    pub fn standard_regressor_of_followers(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        a: &V::Vector,
    ) -> impl Iterator<Item = V::Rows<10>> {
        let joints = self.arm.joints(q);
        let motions = self.arm.motions(&joints, [v, a], self.motion(base, v, a));
        let followers = (0..self.arm.count).filter(|k| self.arm.links[*k].is_follower);
        followers.map(move |k| self.arm.block(k, &joints, &motions))
    }

    /// The block of the [parameters of the base](Table::standard_parameters_of_base). The rows of joints are zero.
    pub fn standard_regressor_of_base(
        &self,
        base: &Pose<f64>,
        v: &V::Vector,
        a: &V::Vector,
    ) -> V::Rows<10> {
        let (mut block, motion) = (self.arm.freedoms.rows(), self.motion(base, v, a));
        for parameter in 0..10 {
            let inertia = Inertia::unit(parameter).placed(&Place::IDENTITY);
            let wrench = inertia.wrench(&motion.linear_acceleration, &motion.spread);
            let entries = wrench.entries().into_iter().enumerate();
            entries.for_each(|(i, entry)| block[(i, parameter)] = entry);
        }
        block
    }

    fn motion(&self, base: &Pose<f64>, v: &V::Vector, a: &V::Vector) -> FrameMotion {
        FrameMotion::moving(&twist::<V>(v), &twist::<V>(a), &self.gravity(base))
    }
}
