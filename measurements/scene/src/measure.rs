//! Operations, time and error of an arm with pieces left out.

use std::hint::black_box;

use clock::Effort;
use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{
    CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix, Operations,
};
use testkit::random::Random;

/// States at which errors are measured.
const STATES: usize = 500;

/// An arm of which all five functions exist.
pub trait Arm<const N: usize>:
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

/// The functions, in the order of [`values`] and [`times`].
pub const FUNCTIONS: [&str; 5] = [
    "inverse_dynamics",
    "mass_matrix",
    "coriolis_vector",
    "gravity_vector",
    "forward_dynamics",
];

/// q, qd, qdd.
pub type State<const N: usize> = [SVector<f64, N>; 3];

/// Random states: positions within pi, velocities within 3 rad/s, accelerations within 10 rad/s^2.
pub fn states<const N: usize>() -> Vec<State<N>> {
    let mut random = Random::seeded(0);
    let state = |_| [std::f64::consts::PI, 3.0, 10.0].map(|limit| random.vector(limit));
    (0..STATES).map(state).collect()
}

/// The values of each function at a state, as lists. `tau` are the joint forces under which the arm
/// is accelerated.
pub fn values<const N: usize>(
    arm: &impl Arm<N>,
    [q, qd, qdd]: &State<N>,
    tau: &SVector<f64, N>,
) -> [Vec<f64>; 5] {
    let accelerations = arm.forward_dynamics(q, qd, tau);
    [
        arm.inverse_dynamics(q, qd, qdd).as_slice().to_vec(),
        arm.mass_matrix(q).as_slice().to_vec(),
        arm.coriolis_vector(q, qd).as_slice().to_vec(),
        arm.gravity_vector(q).as_slice().to_vec(),
        accelerations.map_or(vec![f64::NAN; N], |qdd| qdd.as_slice().to_vec()),
    ]
}

/// The largest difference of each function from the whole arm's over the largest value of that.
pub fn errors<const N: usize>(part: &impl Arm<N>, whole: &impl Arm<N>) -> [f64; 5] {
    let mut largest = [(0.0_f64, 0.0_f64); 5];
    for state in states::<N>() {
        let [q, qd, qdd] = state;
        let tau = whole.inverse_dynamics(&q, &qd, &qdd);
        let (part, whole) = (values(part, &state, &tau), values(whole, &state, &tau));
        for (k, (difference, size)) in largest.iter_mut().enumerate() {
            for (a, b) in part[k].iter().zip(&whole[k]) {
                *difference = difference.max((a - b).abs());
                *size = size.max(b.abs());
            }
        }
    }
    largest.map(|(difference, size)| difference / size)
}

/// Nanoseconds of a call of each function: medians over all states.
pub fn times<const N: usize>(arm: &impl Arm<N>) -> [f64; 5] {
    let states = states::<N>();
    [
        median(&states, |[q, qd, qdd]| {
            black_box(arm.inverse_dynamics(q, qd, qdd));
        }),
        median(&states, |[q, ..]| {
            black_box(arm.mass_matrix(q));
        }),
        median(&states, |[q, qd, _]| {
            black_box(arm.coriolis_vector(q, qd));
        }),
        median(&states, |[q, ..]| {
            black_box(arm.gravity_vector(q));
        }),
        median(&states, |[q, qd, tau]| {
            let _ = black_box(arm.forward_dynamics(q, qd, tau));
        }),
    ]
}

/// Nanoseconds of a call of anything at a state.
pub fn time<const N: usize>(call: impl Fn(&State<N>)) -> f64 {
    median(&states::<N>(), call)
}

fn median<const N: usize>(states: &[State<N>], call: impl Fn(&State<N>)) -> f64 {
    Effort::FULL.nanoseconds(states, call)
}

/// Multiplications, additions and divisions of each function.
pub fn operations(all: &[(&str, Operations)]) -> [u32; 5] {
    FUNCTIONS.map(|function| {
        let found = all.iter().find(|(name, _)| *name == function);
        found.map_or(0, |(_, operations)| operations.total())
    })
}
