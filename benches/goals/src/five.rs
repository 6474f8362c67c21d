//! The five functions that are compared with the trial, one state at a time.

use std::hint::black_box;

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{
    CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix, Scalar,
};

/// Their names, in the order in which they are numbered.
pub(crate) const NAMES: [&str; 5] = [
    "inverse_dynamics",
    "mass_matrix",
    "coriolis_vector",
    "gravity_vector",
    "forward_dynamics",
];

/// An arm that has them.
pub(crate) trait Five<const N: usize>:
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
pub(crate) type Numbers<T, const N: usize> = [SVector<T, N>; 3];

/// A function at every state in turn.
pub(crate) fn calls<A: Five<N>, T: Scalar, const N: usize>(
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

/// The values of a function at every state, in double precision.
pub(crate) fn values<A: Five<N>, T: Scalar, const N: usize>(
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
                vector(found.expect("M is positive definite"))
            }
        }
    };
    let double = |x: T| x.ratio_to_f64(T::from_f64(1.0));
    let all = states.iter().map(value);
    all.map(|value| value.into_iter().map(double).collect())
        .collect()
}
