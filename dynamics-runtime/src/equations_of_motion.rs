//! The equations of motion that a simulation solves: for accelerations, or in positions and momenta.

use nalgebra::{SMatrix, SVector};

use crate::dual::Dual;
use crate::factorisation::Factors;
use crate::{
    ForwardDynamics, InverseDynamics, MassMatrix, Momenta, NewtonEuler, Scalar, SingularMassMatrix,
};

/// Accelerations, and their changes by a unit torque at each of some joints: columns of M^-1.
pub type Responses<const N: usize> = (SVector<f64, N>, SMatrix<f64, N, N>);

/// An arm that a [`Simulation`](crate::Simulation) can move: its equations of motion, solved for the
/// accelerations, in doubles.
///
/// Every arm with [`ForwardDynamics`] is one, and [`NewtonEuler`] is one for any table.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be simulated: `forward_dynamics` was not asked for",
    note = "add it to its `functions:`, or write `functions: [default, ...]`, which holds it"
)]
pub trait EquationsOfMotion<const N: usize> {
    /// Joint accelerations qdd of `M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau`.
    ///
    /// `q` in rad or m, `qd` per second, `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision, or holds a NaN.
    fn accelerations(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix>;

    /// The accelerations, and the columns of M(q)^-1 that belong to `joints`; other columns are zero.
    ///
    /// # Errors
    ///
    /// As [`accelerations`](EquationsOfMotion::accelerations).
    fn accelerations_and_responses(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
        joints: &[bool; N],
    ) -> Result<Responses<N>, SingularMassMatrix>;

    /// The arm in positions and momenta, as the structure-preserving methods need it; `None` for an arm without
    /// these functions.
    fn in_momenta(&self) -> Option<&dyn Momenta<N>>;
}

impl<R: ForwardDynamics<N>, const N: usize> EquationsOfMotion<N> for R {
    #[inline]
    fn accelerations(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        self.forward_dynamics(q, qd, tau)
    }

    /// A column of M^-1 is the derivative by a torque, which a dual number carries along.
    fn accelerations_and_responses(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
        joints: &[bool; N],
    ) -> Result<Responses<N>, SingularMassMatrix> {
        let [positions, velocities] = [q, qd].map(|x| x.map(Dual::from_f64));
        let mut free = None;
        let mut columns = SMatrix::<f64, N, N>::zeros();
        for j in (0..N).filter(|j| joints[*j]) {
            let tau = SVector::from_fn(|i, _| Dual::new(tau[i], f64::from(u8::from(i == j))));
            let qdd = self.forward_dynamics(&positions, &velocities, &tau)?;
            free = Some(qdd.map(|entry| entry.value));
            columns.set_column(j, &qdd.map(|entry| entry.slope));
        }
        match free {
            Some(free) => Ok((free, columns)),
            None => Ok((self.accelerations(q, qd, tau)?, columns)),
        }
    }

    #[inline]
    fn in_momenta(&self) -> Option<&dyn Momenta<N>> {
        self.momenta()
    }
}

impl<const N: usize> EquationsOfMotion<N> for NewtonEuler<N> {
    fn accelerations(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        self.forward_dynamics(q, qd, tau)
    }

    fn accelerations_and_responses(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
        joints: &[bool; N],
    ) -> Result<Responses<N>, SingularMassMatrix> {
        let factors = Factors::new(self.mass_matrix(q))?;
        let mut columns = SMatrix::<f64, N, N>::zeros();
        for j in (0..N).filter(|j| joints[*j]) {
            let unit = SVector::from_fn(|i, _| f64::from(u8::from(i == j)));
            columns.set_column(j, &factors.solve(&unit));
        }
        Ok((factors.solve(&(tau - self.bias_force(q, qd))), columns))
    }

    fn in_momenta(&self) -> Option<&dyn Momenta<N>> {
        Some(self)
    }
}

impl<R: MassMatrix<N> + InverseDynamics<N>, const N: usize> Momenta<N> for R {
    fn inertia(&self, q: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.mass_matrix(q)
    }

    fn force(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let along = SVector::from_fn(|i, _| Dual::new(q[i], qd[i]));
        let mass_rate = self.mass_matrix(&along).map(|entry| entry.slope);
        let bias = self.inverse_dynamics(q, qd, &SVector::zeros());
        tau + mass_rate * qd - bias
    }
}

impl<const N: usize> Momenta<N> for NewtonEuler<N> {
    fn inertia(&self, q: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.mass_matrix(q)
    }

    /// With C of the Christoffel symbols, dT/dq = C' qd.
    fn force(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let of_kinetic_energy = self.coriolis_matrix(q, qd).tr_mul(qd);
        let potential = self.gravity_vector(q) + self.spring_vector(q);
        tau + of_kinetic_energy - potential - self.friction_vector(qd)
    }
}
