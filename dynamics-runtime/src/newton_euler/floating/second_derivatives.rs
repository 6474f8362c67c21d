//! Second derivatives of the forces, by differences that are no approximation.

use super::NumericFloating;
use super::derivatives::unit;
use crate::Pose;
use crate::size::{Size, SizedSecondDerivatives};

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// Second derivatives of the inverse dynamics, as those of an arm, by the displacements x of base and joints:
    /// d2 tau/dx dx, d2 tau/dv dv, d2 tau/dx dv and dM/dx.
    ///
    /// d2 tau/dx dx is the Hessian of f(p + R d, R exp(phi), q) at d = phi = 0: it is symmetric, while repeated derivatives
    /// along the axes of the base are not.
    pub fn inverse_dynamics_second_derivatives(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        a: &V::Vector,
    ) -> SizedSecondDerivatives<V> {
        let (joints, gravity) = (self.arm.joints(q), self.gravity(base));
        let size = self.arm.freedoms;
        let none = || size.each(|_| size.matrix());
        let mut all = (none(), none(), none(), none());
        self.arm.walk_outward(|place| {
            let (k, joint, factor) = (place.k, place.joint, place.factor);
            let slope = &self.arm;
            let by_position =
                slope.slope(&joints, k, |joints| self.slopes(joints, [v, a], &gravity));
            let by_both = slope.slope(&joints, k, |joints| self.by_velocity(joints, v));
            let of_inertia = slope.slope(&joints, k, |joints| self.mass_matrix_of(joints));
            for (i, j) in size
                .joints()
                .flat_map(|i| size.joints().map(move |j| (i, j)))
            {
                all.0[i][(j, joint)] += factor * by_position[(i, j)];
                all.2[i][(joint, j)] += factor * by_both[(i, j)];
                all.3[i][(j, joint)] += factor * of_inertia[(i, j)];
            }
            let curvature = factor * factor * factor * place.link.dry.curvature(place.of(v));
            all.1[joint][(joint, joint)] += curvature;
        });
        for k in size.joints() {
            // dV/dv is linear in v.
            let of_unit = size.vector_of(|i| f64::from(u8::from(i == k)));
            let by_velocity = self.by_velocity(&joints, &of_unit);
            for (i, j) in size
                .joints()
                .flat_map(|i| size.joints().map(move |j| (i, j)))
            {
                all.1[i][(j, k)] += by_velocity[(i, j)];
            }
        }
        for (j, k) in (0..3).flat_map(|j| (0..3).map(move |k| (j, k))) {
            // The terms of degree two of exp(-phi) g are 1/2 phi x (phi x g).
            let twice = |a, b| unit(a).cross(&unit(b).cross(&gravity));
            let column = self.weights(&joints, &((twice(j, k) + twice(k, j)) * 0.5));
            size.joints()
                .for_each(|i| all.0[i][(3 + j, 3 + k)] = column[i]);
        }
        for (joint, turn) in (6..self.dof()).flat_map(|joint| (3..6).map(move |turn| (joint, turn)))
        {
            size.joints()
                .for_each(|i| all.0[i][(joint, turn)] = all.0[i][(turn, joint)]);
        }
        all
    }
}
