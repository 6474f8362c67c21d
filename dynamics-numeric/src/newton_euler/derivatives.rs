//! Derivatives of the joint torques, by differences that are no approximation.
//!
//! tau without springs and friction is linear in products of two entries of a link's transform. So it is a trigonometric
//! polynomial of degree two in each joint angle, and a polynomial of degree two in each displacement and each velocity.
//! Differences over distances that may be large give the derivatives of such functions exactly, with roundings as small
//! as those of tau itself.
//!
//! Displacements of a base that moves are in its own axes: a derivative by the position is that of f(p + R d, R exp(phi), q)
//! at d = phi = 0. Gravity is then `exp(-phi) R' g`, of which the forces are a linear function, and nothing else depends on
//! the base.

use core::f64::consts::{FRAC_1_SQRT_2, SQRT_2};
use core::ops::{Add, Mul, Sub};

use dynamics_runtime::internal::geometry::{Joint, SinCos};
use dynamics_runtime::{JointType, Size};
use nalgebra::Vector3;

use super::{NumericArm, Placed};

/// A turn by 45 degrees.
const EIGHTH: SinCos = SinCos {
    sin: FRAC_1_SQRT_2,
    cos: FRAC_1_SQRT_2,
};
/// A turn by 90 degrees.
const QUARTER: SinCos = SinCos { sin: 1.0, cos: 0.0 };

impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    pub(crate) fn inverse_dynamics_derivatives(
        &self,
        q: &D::Vector,
        qd: &V::Vector,
        qdd: &V::Vector,
    ) -> (V::Matrix, V::Matrix) {
        let joints = self.arm.joints(q);
        let mut by_position = self.slopes(&joints, [qd, qdd]);
        let mut by_velocity = self.arm.by_velocity(&joints, qd);
        self.arm.walk_outward(|place| {
            let (link, square) = (place.link, place.factor * place.factor);
            let diagonal = (place.joint, place.joint);
            by_position[diagonal] += square * link.spring.stiffness;
            by_velocity[diagonal] += square * (link.viscous + link.dry.slope(place.of(qd)));
        });
        (by_position, by_velocity)
    }

    /// The derivative by positions without springs, where the joints are so.
    pub(super) fn slopes(&self, joints: &D::Links<Joint>, motion: [&V::Vector; 2]) -> V::Matrix {
        let (arm, gravity) = (self.arm, &self.base.gravity);
        let mut slopes = arm.freedoms.matrix();
        if arm.floats() {
            for axis in 0..3 {
                // d(exp(-phi) g) = g x phi.
                let column = arm.weights(joints, &gravity.cross(&unit(axis)));
                (0..arm.dof()).for_each(|i| slopes[(i, 3 + axis)] = column[i]);
            }
        }
        let tau = |joints: &D::Links<Joint>| arm.forces(joints, motion, gravity);
        arm.walk_outward(|place| {
            let column = arm.slope(joints, place.k, tau);
            place.add_column(&mut slopes, arm.dof(), |i| column[i]);
        });
        slopes
    }
}

/// One of the three axes.
pub(super) fn unit(axis: usize) -> Vector3<f64> {
    Vector3::ith(axis, 1.0)
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// The derivative by the position of link k's joint of what is such a polynomial of it.
    pub(super) fn slope<X>(
        &self,
        joints: &D::Links<Joint>,
        k: usize,
        value: impl Fn(&D::Links<Joint>) -> X,
    ) -> X
    where
        X: Add<Output = X> + Sub<Output = X> + Mul<f64, Output = X>,
    {
        // The value with the joint moved by a turn or by a distance, less that with it moved the other way.
        let mut all = joints.clone();
        let mut difference = |turn: SinCos, distance: f64| {
            let mut moved = |turn, distance| {
                all[k] = joints[k].moved(turn, distance);
                value(&all)
            };
            moved(turn, distance) - moved(turn.opposite(), -distance)
        };
        match self.links[k].joint_type {
            // With x' = a + 2 b for the terms of degree one and two, the differences are
            // 2 (sqrt(1/2) a + b) over 45 degrees and 2 a over 90 degrees.
            JointType::Revolute => {
                difference(EIGHTH, 0.0) + difference(QUARTER, 0.0) * ((1.0 - SQRT_2) / 2.0)
            }
            JointType::Prismatic => difference(SinCos::ZERO, 1.0) * 0.5,
        }
    }
}
