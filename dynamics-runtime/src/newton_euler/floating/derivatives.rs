//! Derivatives of the forces, by differences that are no approximation.
//!
//! Displacements of the base are in its own axes: a derivative by the position is that of f(p + R d, R exp(phi), q) at
//! d = phi = 0. Gravity is then `exp(-phi) R' g`, of which the forces are a linear function, and nothing else depends on the
//! base. By the joints the forces are polynomials of degree two, as those of arms are.

use nalgebra::Vector3;

use super::NumericFloating;
use crate::Pose;
use crate::newton_euler::joint::Joint;
use crate::size::{JointVector as _, Size};

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// Derivatives of the inverse dynamics by the displacements of base and joints and by v, each V x V; row i belongs to
    /// force i. Columns of displacements without a turn of the base are zero.
    ///
    /// The stiffness of springs is on the diagonal of the first one, viscous friction on that of the second. Coulomb friction
    /// is taken as constant.
    pub fn inverse_dynamics_derivatives(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        a: &V::Vector,
    ) -> (V::Matrix, V::Matrix) {
        let (joints, gravity) = (self.arm.joints(q), self.gravity(base));
        let mut by_position = self.slopes(&joints, [v, a], &gravity);
        let mut by_velocity = self.by_velocity(&joints, v);
        self.arm.walk_outward(|place| {
            let (link, square) = (place.link, place.factor * place.factor);
            let diagonal = (place.joint, place.joint);
            by_position[diagonal] += square * link.spring.stiffness;
            by_velocity[diagonal] += square * (link.viscous + link.dry.slope(place.of(v)));
        });
        (by_position, by_velocity)
    }

    /// The derivative by displacements without springs, where the joints are so.
    pub(super) fn slopes(
        &self,
        joints: &D::Links<Joint>,
        motion: [&V::Vector; 2],
        gravity: &Vector3<f64>,
    ) -> V::Matrix {
        let (mut slopes, size) = (self.arm.freedoms.matrix(), self.dof());
        for axis in 0..3 {
            // d(exp(-phi) g) = g x phi.
            let turned = gravity.cross(&unit(axis));
            let column = self.weights(joints, &turned);
            (0..size).for_each(|i| slopes[(i, 3 + axis)] = column[i]);
        }
        let forces = |joints: &D::Links<Joint>| self.forces(joints, motion, gravity);
        self.arm.walk_outward(|place| {
            let column = self.arm.slope(joints, place.k, forces);
            place.add_column(&mut slopes, size, |i| column[i]);
        });
        slopes
    }

    /// dV/dv where the joints are so. V is quadratic in v, so its central difference over any distance is the derivative
    /// itself; the greatest speed keeps rounding at the scale of the result.
    pub(super) fn by_velocity(&self, joints: &D::Links<Joint>, v: &V::Vector) -> V::Matrix {
        let (mut slopes, h) = (self.arm.freedoms.matrix(), v.largest());
        if h == 0.0 {
            return slopes;
        }
        for j in self.arm.freedoms.joints() {
            let moved = |distance: f64| {
                let mut v = v.clone();
                v[j] += distance;
                self.velocity_forces(joints, &v)
            };
            let difference = moved(h) - moved(-h);
            for i in self.arm.freedoms.joints() {
                slopes[(i, j)] = difference[i] / (2.0 * h);
            }
        }
        slopes
    }
}

/// One of the three axes.
pub(super) fn unit(axis: usize) -> Vector3<f64> {
    Vector3::ith(axis, 1.0)
}
