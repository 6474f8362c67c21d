//! The five functions whose times and errors are measured everywhere, one state at a time.

use std::hint::black_box;

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{
    CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix, Scalar,
};

/// Their names, in the order in which they are numbered.
pub const NAMES: [&str; 5] = [
    "inverse_dynamics",
    "mass_matrix",
    "coriolis_vector",
    "gravity_vector",
    "forward_dynamics",
];

/// An arm that has them.
pub trait Five<const N: usize>:
    MassMatrix<N> + CoriolisVector<N> + GravityVector<N> + InverseDynamics<N> + ForwardDynamics<N>
{
}

impl<A, const N: usize> Five<N> for A where
    A: MassMatrix<N>
        + CoriolisVector<N>
        + GravityVector<N>
        + InverseDynamics<N>
        + ForwardDynamics<N>
{
}

/// Positions, velocities, and accelerations or torques of a state.
pub type Numbers<T, const N: usize> = [SVector<T, N>; 3];

/// States spread over the joints' circles, in numbers that single precision holds.
pub fn states<T: Scalar, const N: usize>(count: usize) -> Vec<Numbers<T, N>> {
    let number = |phase: f64, state: usize, joint: usize| {
        let x = (phase + 1.7 * state as f64 + 2.3 * joint as f64).sin() * 3.0;
        T::from_f64(f64::from(x as f32))
    };
    let vector = |phase, state| SVector::from_fn(|joint, _| number(phase, state, joint));
    (0..count)
        .map(|state| [0.1, 0.7, 1.9].map(|phase| vector(phase, state)))
        .collect()
}

/// A function at every state in turn.
pub fn calls<A: Five<N>, T: Scalar, const N: usize>(
    arm: &A,
    function: usize,
    states: &[Numbers<T, N>],
) {
    macro_rules! each {
        (|$q:ident, $qd:ident, $x:ident| $value:expr) => {
            for state in states {
                let [$q, $qd, $x] = black_box(state);
                let _ = ($qd, $x);
                // Not the value, which would be copied: a processor waits before it copies what was just written.
                black_box(&$value);
            }
        };
    }
    match function {
        0 => each!(|q, qd, qdd| arm.inverse_dynamics(q, qd, qdd)),
        1 => each!(|q, qd, qdd| arm.mass_matrix(q)),
        2 => each!(|q, qd, qdd| arm.coriolis_vector(q, qd)),
        3 => each!(|q, qd, qdd| arm.gravity_vector(q)),
        _ => each!(|q, qd, tau| arm.forward_dynamics(q, qd, tau).ok()),
    }
}

/// The values of a function at every state, in double precision; no accelerations are NaN.
pub fn values<A: Five<N>, T: Scalar, const N: usize>(
    arm: &A,
    function: usize,
    states: &[Numbers<T, N>],
) -> Vec<Vec<f64>> {
    let vector = |v: SVector<T, N>| v.iter().copied().collect();
    let value = |[q, qd, x]: &Numbers<T, N>| -> Vec<T> {
        match function {
            0 => vector(arm.inverse_dynamics(q, qd, x)),
            1 => arm.mass_matrix(q).iter().copied().collect(),
            2 => vector(arm.coriolis_vector(q, qd)),
            3 => vector(arm.gravity_vector(q)),
            _ => {
                let found = arm.forward_dynamics(q, qd, x);
                vector(found.unwrap_or_else(|_| SVector::repeat(T::from_f64(f64::NAN))))
            }
        }
    };
    let double = |x: T| x.ratio_to_f64(T::from_f64(1.0));
    let all = states.iter().map(value);
    all.map(|value| value.into_iter().map(double).collect())
        .collect()
}

/// The largest error of any state, relative to the largest entry of its value; NaN where one is not a number.
pub fn largest_error(found: &[Vec<f64>], exact: &[Vec<f64>]) -> f64 {
    let of_state = |(found, exact): (&Vec<f64>, &Vec<f64>)| {
        let largest = exact.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let errors = found
            .iter()
            .zip(exact)
            .map(|(x, exact)| (x - exact).abs() / largest);
        errors.fold(0.0, |worst, x| if x <= worst { worst } else { x })
    };
    found
        .iter()
        .zip(exact)
        .map(of_state)
        .fold(0.0, |worst, x| if x <= worst { worst } else { x })
}
