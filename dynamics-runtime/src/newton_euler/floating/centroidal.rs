//! Linear momentum, and angular momentum about the centre of mass.
//!
//! Source: D. E. Orin, A. Goswami, S.-H. Lee, *Centroidal dynamics of a humanoid robot*, Autonomous Robots 35 (2013), 161-176:
//! the momenta of all bodies are the first six rows of M, brought to the centre of mass.

use nalgebra::{Vector3, Vector6};

use super::NumericFloating;
use crate::Pose;
use crate::newton_euler::kinematics::joined;
use crate::size::Size;

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// Centroidal momentum matrix A, 6 x V: A v is the linear momentum, then the angular momentum about the centre of mass, in
    /// the axes of the world, kg m/s and kg m^2/s. Reflected inertias of motors have no part in it.
    pub fn centroidal_momentum_matrix(&self, base: &Pose<f64>, q: &D::Vector) -> V::Columns<6> {
        let (mass_matrix, size) = (self.mass_matrix(q), self.arm.freedoms);
        let mut columns = size.columns();
        for j in size.joints() {
            let momentum = Vector6::from_fn(|i, _| mass_matrix[(i, j)]);
            let column = self.to_center(base, q, &momentum);
            (0..6).for_each(|i| columns[(i, j)] = column[i]);
        }
        columns
    }

    /// dA/dt v: the rate of that momentum without acceleration. The force on the base and its moment are this rate where
    /// nothing else acts.
    pub fn centroidal_momentum_bias(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
    ) -> Vector6<f64> {
        let force = self.coriolis_vector(q, v);
        self.to_center(base, q, &Vector6::from_fn(|i, _| force[i]))
    }

    /// From the origin and the axes of the base to the centre of mass and the axes of the world.
    fn to_center(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        about_base: &Vector6<f64>,
    ) -> Vector6<f64> {
        let arm = self.center_of_mass(base, q) - base.position;
        let [linear, angular] =
            [0, 3].map(|k| base.rotation * Vector3::from_fn(|i, _| about_base[k + i]));
        joined(&linear, &(angular - arm.cross(&linear)))
    }
}
