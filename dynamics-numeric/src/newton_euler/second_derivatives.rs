//! Second derivatives of the joint torques, by differences that are no approximation.
//!
//! The derivatives of tau by positions are polynomials of the same degrees as tau itself, and so are M and dV/dqd.

use dynamics_runtime::{Size, SizedSecondDerivatives};

use super::Placed;
use super::derivatives::unit;

impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    pub(crate) fn inverse_dynamics_second_derivatives(
        &self,
        q: &D::Vector,
        qd: &V::Vector,
        qdd: &V::Vector,
    ) -> SizedSecondDerivatives<V> {
        let (arm, size) = (self.arm, self.arm.freedoms);
        let joints = arm.joints(q);
        let none = || size.each(|_| size.matrix());
        let mut all = (none(), none(), none(), none());
        let pairs = || {
            let rows = size.joints();
            rows.flat_map(|i| size.joints().map(move |j| (i, j)))
        };
        arm.walk_outward(|place| {
            let (k, joint, factor) = (place.k, place.joint, place.factor);
            let by_position = arm.slope(&joints, k, |joints| self.slopes(joints, [qd, qdd]));
            let by_both = arm.slope(&joints, k, |joints| arm.by_velocity(joints, qd));
            let of_inertia = arm.slope(&joints, k, |joints| arm.composite_bodies(joints));
            for (i, j) in pairs() {
                all.0[i][(j, joint)] += factor * by_position[(i, j)];
                all.2[i][(joint, j)] += factor * by_both[(i, j)];
                all.3[i][(j, joint)] += factor * of_inertia[(i, j)];
            }
            let curvature = factor * factor * factor * place.link.dry.curvature(place.of(qd));
            all.1[joint][(joint, joint)] += curvature;
        });
        for k in size.joints() {
            // dV/dqd is linear in qd.
            let of_unit = size.vector_of(|i| f64::from(u8::from(i == k)));
            let by_velocity = arm.by_velocity(&joints, &of_unit);
            for (i, j) in pairs() {
                all.1[i][(j, k)] += by_velocity[(i, j)];
            }
        }
        if arm.floats() {
            let gravity = &self.base.gravity;
            for (j, k) in (0..3).flat_map(|j| (0..3).map(move |k| (j, k))) {
                // The terms of degree two of exp(-phi) g are 1/2 phi x (phi x g).
                let twice = |a, b| unit(a).cross(&unit(b).cross(gravity));
                let column = arm.weights(&joints, &((twice(j, k) + twice(k, j)) * 0.5));
                size.joints()
                    .for_each(|i| all.0[i][(3 + j, 3 + k)] = column[i]);
            }
            for (joint, turn) in (6..arm.dof()).flat_map(|joint| (3..6).map(move |k| (joint, k))) {
                size.joints()
                    .for_each(|i| all.0[i][(joint, turn)] = all.0[i][(turn, joint)]);
            }
        }
        all
    }
}
