//! Generalized momenta and their rate.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::pose::Lift;
use super::{Definition, Vector};

impl Definition {
    /// dT/dqd_i = T(qd + e_i) - T(qd) - T(e_i), for T is quadratic in qd.
    pub(super) fn generalized_momentum(&self) -> Vector {
        let energy = |qd: &[Number]| self.kinetic_energy(&self.q, qd);
        let whole = energy(&self.qd);
        let momentum = |i: usize| {
            let mut unit = vec![Number::ZERO; self.dof()];
            unit[i] = Number::ONE;
            let both: Vector = self.qd.iter().zip(&unit).map(|(&a, &b)| a + b).collect();
            energy(&both) - whole - energy(&unit)
        };
        (0..self.dof()).map(momentum).collect()
    }

    /// dT/dq - G - K - F: by Lagrange d/dt (dT/dqd) = tau + dT/dq - dU/dq - F.
    pub(super) fn momentum_bias(&self) -> Vector {
        let qd: Vec<_> = self.qd.iter().map(|&x| Dual::lift(x)).collect();
        let slope = |i: usize| self.kinetic_energy(&self.along(i), &qd).derivative;
        let forces = self.gravity_vector().into_iter().zip(self.joint_forces());
        let forces = forces.enumerate();
        forces.map(|(i, (g, f))| slope(i) - g - f).collect()
    }
}
