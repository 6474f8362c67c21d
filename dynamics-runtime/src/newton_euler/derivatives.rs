//! Derivatives of the joint torques, by differences that are no approximation.
//!
//! tau without springs and friction is linear in products of two entries of a link's transform. So it is a trigonometric
//! polynomial of degree two in each joint angle, and a polynomial of degree two in each displacement and each velocity.
//! Differences over distances that may be large give the derivatives of such functions exactly, with roundings as small
//! as those of tau itself.

use core::f64::consts::{FRAC_1_SQRT_2, SQRT_2};
use core::ops::{Add, Mul, Sub};

use super::NumericArm;
use super::angle::SinCos;
use super::joint::Joint;
use crate::JointType;
use crate::size::Size;

/// A turn by 45 degrees.
const EIGHTH: SinCos = SinCos {
    sin: FRAC_1_SQRT_2,
    cos: FRAC_1_SQRT_2,
};
/// A turn by 90 degrees.
const QUARTER: SinCos = SinCos { sin: 1.0, cos: 0.0 };

impl<D: Size> NumericArm<D> {
    /// d tau/dq and d tau/dqd of the inverse dynamics; row i belongs to tau_i, column j to joint j.
    ///
    /// The stiffness of springs is on the diagonal of d tau/dq, viscous friction on that of d tau/dqd.
    /// Coulomb friction is taken as constant.
    pub fn inverse_dynamics_derivatives(
        &self,
        q: &D::Vector,
        qd: &D::Vector,
        qdd: &D::Vector,
    ) -> (D::Matrix, D::Matrix) {
        let joints = self.joints(q);
        let mut by_position = self.slopes(&joints, qd, qdd);
        // C = 1/2 dV/dqd, for the symbols of Christoffel.
        let mut by_velocity = self.coriolis_matrix_of(&joints, qd) * 2.0;
        self.walk_outward(|place| {
            let (link, square) = (place.link, place.factor * place.factor);
            let diagonal = (place.joint, place.joint);
            by_position[diagonal] += square * link.spring.stiffness;
            by_velocity[diagonal] += square * (link.viscous + link.dry.slope(place.of(qd)));
        });
        (by_position, by_velocity)
    }

    /// d tau/dq without springs, where the joints are so.
    pub(super) fn slopes(
        &self,
        joints: &D::Links<Joint>,
        qd: &D::Vector,
        qdd: &D::Vector,
    ) -> D::Matrix {
        let mut slopes = self.size.matrix();
        let tau = |joints: &D::Links<Joint>| self.recursion(joints, qd, qdd, &self.gravity);
        self.walk_outward(|place| {
            let column = self.slope(joints, place.k, tau);
            place.add_column(&mut slopes, self.dof(), |i| column[i]);
        });
        slopes
    }
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
