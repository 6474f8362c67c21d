//! All functions that have a batch, at all states, in either layout.

use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    Batch, CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix,
    batch::BatchError,
};
use testkit::random::Random;

/// An arm with all functions that have a batch.
pub(crate) trait Arm<const N: usize>:
    MassMatrix<N> + CoriolisVector<N> + GravityVector<N> + InverseDynamics<N> + ForwardDynamics<N>
{
}

impl<R, const N: usize> Arm<N> for R where
    R: MassMatrix<N>
        + CoriolisVector<N>
        + GravityVector<N>
        + InverseDynamics<N>
        + ForwardDynamics<N>
{
}

/// The arguments of a batch: one vector for each state.
#[derive(Clone)]
pub(crate) struct States<const N: usize> {
    pub(crate) q: Vec<SVector<f64, N>>,
    pub(crate) qd: Vec<SVector<f64, N>>,
    /// Accelerations, and torques too.
    pub(crate) x: Vec<SVector<f64, N>>,
}

impl<const N: usize> States<N> {
    /// Random states; in every third one a joint rests, for the sign of its velocity.
    pub(crate) fn random(count: usize, seed: u64) -> Self {
        let mut random = Random::seeded(seed);
        let mut states = |limit| (0..count).map(|_| random.vector(limit)).collect::<Vec<_>>();
        let (q, mut qd, x) = (states(3.0), states(3.0), states(10.0));
        for (i, qd) in qd.iter_mut().enumerate().filter(|(i, _)| i % 3 == 0) {
            qd[i % N] = 0.0;
        }
        States { q, qd, x }
    }

    pub(crate) fn truncated(&self, count: usize) -> Self {
        let States { q, qd, x } = self;
        let [q, qd, x] = [q, qd, x].map(|states| states[..count].to_vec());
        States { q, qd, x }
    }
}

/// The results of all functions.
#[derive(Debug)]
pub(crate) struct Values<const N: usize> {
    pub(crate) mass_matrix: Vec<SMatrix<f64, N, N>>,
    pub(crate) coriolis_vector: Vec<SVector<f64, N>>,
    pub(crate) gravity_vector: Vec<SVector<f64, N>>,
    pub(crate) inverse_dynamics: Vec<SVector<f64, N>>,
    pub(crate) forward_dynamics: Vec<SVector<f64, N>>,
    pub(crate) error: Option<BatchError>,
}

impl<const N: usize> Values<N> {
    /// Room, filled with what no function puts out.
    fn room(count: usize) -> Self {
        let vectors = vec![SVector::repeat(1234.5); count];
        Values {
            mass_matrix: vec![SMatrix::repeat(1234.5); count],
            coriolis_vector: vectors.clone(),
            gravity_vector: vectors.clone(),
            inverse_dynamics: vectors.clone(),
            forward_dynamics: vectors,
            error: None,
        }
    }

    /// One call for each state.
    pub(crate) fn single(arm: &impl Arm<N>, states: &States<N>) -> Self {
        let mut values = Values::room(states.q.len());
        for (i, ((q, qd), x)) in states.q.iter().zip(&states.qd).zip(&states.x).enumerate() {
            values.mass_matrix[i] = arm.mass_matrix(q);
            values.coriolis_vector[i] = arm.coriolis_vector(q, qd);
            values.gravity_vector[i] = arm.gravity_vector(q);
            values.inverse_dynamics[i] = arm.inverse_dynamics(q, qd, x);
            let accelerations = arm.forward_dynamics(q, qd, x);
            values.forward_dynamics[i] = accelerations.unwrap_or(SVector::repeat(f64::NAN));
            let error = accelerations.err();
            let error = error.map(|error| BatchError::Singular { state: i, error });
            values.error = values.error.or(error);
        }
        values
    }

    /// A vector for each state, in and out.
    pub(crate) fn by_rows(arm: &impl Arm<N>, States { q, qd, x }: &States<N>) -> Self {
        let mut v = Values::room(q.len());
        arm.mass_matrix_batch(q, &mut v.mass_matrix).unwrap();
        arm.coriolis_vector_batch(q, qd, &mut v.coriolis_vector)
            .unwrap();
        arm.gravity_vector_batch(q, &mut v.gravity_vector).unwrap();
        arm.inverse_dynamics_batch(q, qd, x, &mut v.inverse_dynamics)
            .unwrap();
        v.error = arm
            .forward_dynamics_batch(q, qd, x, &mut v.forward_dynamics)
            .err();
        v
    }

    /// A column for each joint, in and out.
    pub(crate) fn by_columns(arm: &impl Arm<N>, states: &States<N>) -> Self {
        let count = states.q.len();
        let mut values = Values::room(count);
        let [q, qd, x] = [&states.q, &states.qd, &states.x].map(|states| columns(states));
        let [q, qd, x] = [&q, &qd, &x].map(|columns| columns.each_ref().map(|c| &c[..]));
        let mut out: [Vec<f64>; N] = std::array::from_fn(|_| vec![1234.5; count]);
        let mut entries: [[Vec<f64>; N]; N] = std::array::from_fn(|_| out.clone());
        let matrix = entries
            .each_mut()
            .map(|columns| columns.each_mut().map(|c| &mut c[..]));
        arm.mass_matrix_batch(q, matrix).unwrap();
        for (state, m) in values.mass_matrix.iter_mut().enumerate() {
            *m = SMatrix::from_fn(|i, j| entries[j][i][state]);
        }
        arm.coriolis_vector_batch(q, qd, views(&mut out)).unwrap();
        values.coriolis_vector = rows(&out);
        arm.gravity_vector_batch(q, views(&mut out)).unwrap();
        values.gravity_vector = rows(&out);
        arm.inverse_dynamics_batch(q, qd, x, views(&mut out))
            .unwrap();
        values.inverse_dynamics = rows(&out);
        values.error = arm.forward_dynamics_batch(q, qd, x, views(&mut out)).err();
        values.forward_dynamics = rows(&out);
        values
    }

    pub(crate) fn truncated(&self, count: usize) -> Self {
        Values {
            mass_matrix: self.mass_matrix[..count].to_vec(),
            coriolis_vector: self.coriolis_vector[..count].to_vec(),
            gravity_vector: self.gravity_vector[..count].to_vec(),
            inverse_dynamics: self.inverse_dynamics[..count].to_vec(),
            forward_dynamics: self.forward_dynamics[..count].to_vec(),
            error: self.error,
        }
    }

    /// Every number: of the function, of the state.
    pub(crate) fn numbers(&self) -> [(&'static str, Vec<&[f64]>); 5] {
        fn slices<const N: usize>(vectors: &[SVector<f64, N>]) -> Vec<&[f64]> {
            vectors.iter().map(|vector| vector.as_slice()).collect()
        }
        [
            ("M", self.mass_matrix.iter().map(|m| m.as_slice()).collect()),
            ("V", slices(&self.coriolis_vector)),
            ("G", slices(&self.gravity_vector)),
            ("tau", slices(&self.inverse_dynamics)),
            ("qdd", slices(&self.forward_dynamics)),
        ]
    }
}

/// A column for each joint.
pub(crate) fn columns<const N: usize>(states: &[SVector<f64, N>]) -> [Vec<f64>; N] {
    std::array::from_fn(|joint| states.iter().map(|state| state[joint]).collect())
}

fn rows<const N: usize>(columns: &[Vec<f64>; N]) -> Vec<SVector<f64, N>> {
    let count = columns[0].len();
    (0..count)
        .map(|state| SVector::from_fn(|joint, _| columns[joint][state]))
        .collect()
}

fn views<const N: usize>(columns: &mut [Vec<f64>; N]) -> [&mut [f64]; N] {
    columns.each_mut().map(|column| &mut column[..])
}

/// Asserts that all numbers are the same, bit by bit.
#[track_caller]
pub(crate) fn assert_same<const N: usize>(a: &Values<N>, b: &Values<N>) {
    for ((function, a), (_, b)) in a.numbers().into_iter().zip(b.numbers()) {
        assert_eq!(a.len(), b.len());
        for (state, (a, b)) in a.iter().zip(b).enumerate() {
            let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert_eq!(
                bits(a),
                bits(b),
                "{function} of state {state}: {a:?} and {b:?}"
            );
        }
    }
}
