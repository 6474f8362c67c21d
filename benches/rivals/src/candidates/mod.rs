//! The ways of computing the five functions of an arm.

mod batch;
mod dynibo;
mod generated;
mod numeric;
#[cfg(feature = "symplex")]
mod symplex;

use robot_dynamics::State;
use robot_dynamics::nalgebra::{SMatrix, SVector};

pub(crate) use batch::Lanes;
pub(crate) use dynibo::Dynibo;
pub(crate) use generated::GENERATED;
#[cfg(feature = "symplex")]
pub(crate) use symplex::Symplex;

/// A way of computing the five functions of an arm.
pub(crate) trait Candidate<const N: usize> {
    const NAME: &'static str;

    fn inverse_dynamics(
        &mut self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> SVector<f64, N>;
    fn mass_matrix(&mut self, q: &SVector<f64, N>) -> SMatrix<f64, N, N>;
    fn coriolis_vector(&mut self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SVector<f64, N>;
    fn gravity_vector(&mut self, q: &SVector<f64, N>) -> SVector<f64, N>;
    fn forward_dynamics(
        &mut self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Option<SVector<f64, N>>;

    /// All five values of the table's own arm; a candidate that leaves a part of the model out
    /// adds it here.
    fn values(&mut self, state: &State<N>, tau: &SVector<f64, N>) -> Values<N> {
        let State { q, qd, qdd } = state;
        Values {
            inverse_dynamics: self.inverse_dynamics(q, qd, qdd),
            mass_matrix: self.mass_matrix(q),
            coriolis_vector: self.coriolis_vector(q, qd),
            gravity_vector: self.gravity_vector(q),
            forward_dynamics: self
                .forward_dynamics(q, qd, tau)
                .expect("M is positive definite"),
        }
    }
}

/// The five values at a state.
pub(crate) struct Values<const N: usize> {
    pub(crate) inverse_dynamics: SVector<f64, N>,
    pub(crate) mass_matrix: SMatrix<f64, N, N>,
    pub(crate) coriolis_vector: SVector<f64, N>,
    pub(crate) gravity_vector: SVector<f64, N>,
    pub(crate) forward_dynamics: SVector<f64, N>,
}
