//! The states at which functions are timed.

use robot_dynamics::State;
use robot_dynamics::nalgebra::SVector;

/// Number of states: a function is evaluated at each in turn.
pub(crate) const STATES: usize = 64;

/// States spread over the joints' circles; positions of sliding joints within 3 m.
pub(crate) fn states<const N: usize>() -> Vec<State<N>> {
    let vector = |phase: f64, state: usize| {
        SVector::from_fn(|joint, _| (phase + 1.7 * state as f64 + 2.3 * joint as f64).sin() * 3.0)
    };
    (0..STATES)
        .map(|i| State {
            q: vector(0.1, i),
            qd: vector(0.7, i),
            qdd: vector(1.9, i),
        })
        .collect()
}
