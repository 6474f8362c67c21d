//! The generated functions in the lanes of vector registers, a column for each joint.

use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    Batch, CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix, State,
};

use super::Candidate;

/// An arm whose functions are evaluated by their batches.
pub(crate) struct Lanes<A>(pub(crate) A);

/// Batches of one state, for the errors. It takes a group of lanes like any other.
impl<A, const N: usize> Candidate<N> for Lanes<A>
where
    A: MassMatrix<N> + CoriolisVector<N> + GravityVector<N> + InverseDynamics<N>,
    A: ForwardDynamics<N>,
{
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

/// Many states by columns.
pub(crate) struct Columns<const N: usize> {
    q: [Vec<f64>; N],
    qd: [Vec<f64>; N],
    /// qdd, or tau.
    last: [Vec<f64>; N],
    vector: [Vec<f64>; N],
    matrix: [[Vec<f64>; N]; N],
}

impl<const N: usize> Columns<N> {
    pub(crate) fn new(states: &[State<N>]) -> Self {
        let columns = |vector: fn(&State<N>) -> &SVector<f64, N>| -> [Vec<f64>; N] {
            std::array::from_fn(|joint| states.iter().map(|s| vector(s)[joint]).collect())
        };
        let zeros = || std::array::from_fn(|_| vec![0.0; states.len()]);
        Columns {
            q: columns(|s| &s.q),
            qd: columns(|s| &s.qd),
            last: columns(|s| &s.qdd),
            vector: zeros(),
            matrix: std::array::from_fn(|_| zeros()),
        }
    }

    /// Evaluates the function of that place in [`crate::measure::FUNCTIONS`] at all states.
    pub(crate) fn evaluate<A>(&mut self, function: usize, arm: &A)
    where
        A: MassMatrix<N> + CoriolisVector<N> + GravityVector<N> + InverseDynamics<N>,
        A: ForwardDynamics<N>,
    {
        let (q, qd, last) = (views(&self.q), views(&self.qd), views(&self.last));
        let vector = self.vector.each_mut().map(|column| &mut column[..]);
        let written = match function {
            0 => arm.inverse_dynamics_batch(q, qd, last, vector),
            1 => {
                let matrix = self.matrix.each_mut();
                let matrix = matrix.map(|row| row.each_mut().map(|column| &mut column[..]));
                arm.mass_matrix_batch(q, matrix)
            }
            2 => arm.coriolis_vector_batch(q, qd, vector),
            3 => arm.gravity_vector_batch(q, vector),
            _ => {
                arm.forward_dynamics_batch(q, qd, last, vector)
                    .expect("M is positive definite");
                Ok(())
            }
        };
        written.expect("columns of one length");
    }
}

fn views<const N: usize>(columns: &[Vec<f64>; N]) -> [&[f64]; N] {
    columns.each_ref().map(|column| &column[..])
}
