//! The first two derivatives of the forces along a motion.

use nalgebra::{Matrix3, Vector3};

use super::{NumericFloating, twist};
use crate::Pose;
use crate::newton_euler::rates::{
    FrameJets, Solid, Vector, added, apply, cross, fixed, minus, sum,
};
use crate::size::Size;

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// First and second derivative by time of the forces M a + V + G + K + F along a motion; `jerk` and `snap` are the first
    /// two derivatives of `a`. Coulomb friction counts as constant.
    ///
    /// Newton and Euler are written down in a frame at rest that the base passes at this moment. Its axes turn against that
    /// frame by `R' = R [w]x`, and the force and the moment on it are seen from it.
    pub fn inverse_dynamics_rates(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        a: &V::Vector,
        jerk: &V::Vector,
        snap: &V::Vector,
    ) -> (V::Vector, V::Vector) {
        let rates = [v, a, jerk, snap];
        let [of_v, of_a, of_jerk, of_snap] = rates.map(|rate| twist::<V>(rate));
        let part = |k: usize| -> [Vector; 2] {
            [
                [of_v[k], of_a[k], of_jerk[k]],
                [of_a[k], of_jerk[k], of_snap[k]],
            ]
        };
        let ([linear, linear_rate], [angular, angular_rate]) = (part(0), part(1));
        let (w, wd) = (angular[0].cross_matrix(), angular[1].cross_matrix());
        let rotation = [Matrix3::identity(), w, w * w + wd];
        let velocity = apply(rotation, linear);
        let acceleration = sum(linear_rate, cross(angular, linear));
        let frame = FrameJets {
            rotation,
            position: [Vector3::zeros(), velocity[0], velocity[1]],
            velocity: apply(rotation, angular),
            acceleration: apply(rotation, angular_rate),
            linear: sum(
                apply(rotation, acceleration),
                minus(fixed(self.gravity(base))),
            ),
        };
        let (mut torques, links) = self.arm.force_rates(q, rates, &frame);
        let solid = Solid {
            mass: self.body.mass,
            com: self.body.com,
            tensor: self.body.tensor,
        };
        let wrench = added(links, frame.load(&solid).about(&frame.position));
        let transposed = rotation.map(|r| r.transpose());
        for (first, part) in [0, 3].into_iter().zip(wrench) {
            let [_, rate, second] = apply(transposed, part);
            for i in 0..3 {
                torques.0[first + i] = rate[i];
                torques.1[first + i] = second[i];
            }
        }
        torques
    }
}
