//! The generated functions in the lanes of vector registers.

use robot_dynamics::Batch;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use testkit::five::Five;

use super::Candidate;

/// An arm whose functions are evaluated by their batches.
pub(crate) struct Lanes<A>(pub(crate) A);

/// Batches of one state, for the errors. It takes a group of lanes like any other.
impl<A: Five<N>, const N: usize> Candidate<N> for Lanes<A> {
    const NAME: &'static str = "batch";

    fn inverse_dynamics(
        &mut self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let mut tau = [SVector::zeros()];
        let arguments = ([*q], [*qd], [*qdd]);
        self.0
            .inverse_dynamics_batch(&arguments.0, &arguments.1, &arguments.2, &mut tau)
            .expect("one state each");
        tau[0]
    }

    fn mass_matrix(&mut self, q: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        let mut m = [SMatrix::zeros()];
        self.0
            .mass_matrix_batch(&[*q], &mut m)
            .expect("one state each");
        m[0]
    }

    fn coriolis_vector(&mut self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SVector<f64, N> {
        let mut v = [SVector::zeros()];
        self.0
            .coriolis_vector_batch(&[*q], &[*qd], &mut v)
            .expect("one state each");
        v[0]
    }

    fn gravity_vector(&mut self, q: &SVector<f64, N>) -> SVector<f64, N> {
        let mut g = [SVector::zeros()];
        self.0
            .gravity_vector_batch(&[*q], &mut g)
            .expect("one state each");
        g[0]
    }

    fn forward_dynamics(
        &mut self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Option<SVector<f64, N>> {
        let mut qdd = [SVector::zeros()];
        let arguments = ([*q], [*qd], [*tau]);
        self.0
            .forward_dynamics_batch(&arguments.0, &arguments.1, &arguments.2, &mut qdd)
            .ok()?;
        Some(qdd[0])
    }
}
