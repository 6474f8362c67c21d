//! The momentum of all bodies about their centre of mass.
//!
//!   p = sum m c_i',   l = sum R_i I_i w_i + (c_i - c) x m c_i',   c = sum m c_i / sum m,
//!
//! of the bodies that can move, with the derivatives c_i' and [w_i]x = R_i^T R_i'. Column j of A is that of unit velocity
//! of degree of freedom j, and dA/dt v the rate of A v along a motion with constant velocities.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::configuration::Configuration;
use super::equations::constant;
use super::pose::Lift;
use super::{Definition, Vector};
use crate::linear::Vector3;

impl Definition {
    /// A by rows; none of an arm without mass.
    pub(super) fn centroidal_momentum_matrix(&self) -> Option<Vector> {
        let of_unit_mass = self.moving_mass().inverse()?;
        let column = |j: usize| self.momentum(&self.along(j), of_unit_mass).to_vec();
        Some(self.by_columns(column).concat())
    }

    /// dA/dt v
    pub(super) fn centroidal_momentum_bias(&self) -> Option<Vector> {
        let of_unit_mass = self.moving_mass().inverse()?;
        let along_motion = self.moving(&self.q, &self.qd);
        let motion = self.moving(&along_motion, &constant(&self.qd));
        let momentum = self.momentum(&motion, of_unit_mass);
        Some(momentum.map(|x| x.derivative).to_vec())
    }

    /// p and l along the derivative of a configuration, with 1 / sum m.
    fn momentum<R: Lift>(&self, q: &Configuration<Dual<R>>, of_unit_mass: Number) -> [R; 6] {
        let none = Vector3::splat(R::lift(Number::ZERO));
        let (mut moment, mut linear, mut angular) = (none, none, none);
        for (body, pose) in self.moving_bodies(q) {
            let (mass, center) = (R::lift(body.mass), body.center(&pose).0);
            let place = Vector3(center.map(|x| x.value));
            let momentum = Vector3(center.map(|x| x.derivative)) * mass;
            let own = body.tensor().apply(pose.angular_velocity());
            moment = moment + place * mass;
            linear = linear + momentum;
            angular = angular + pose.axes().apply(own) + place.cross(momentum);
        }
        let center = moment * R::lift(of_unit_mass);
        let ([px, py, pz], [lx, ly, lz]) = (linear.0, (angular - center.cross(linear)).0);
        [px, py, pz, lx, ly, lz]
    }
}
