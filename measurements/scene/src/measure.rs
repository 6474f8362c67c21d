//! Operations, time and error of an arm with pieces left out.

use measuring::Effort;
use robot_dynamics::Operations;
use testkit::five::{Five, NAMES, Numbers, calls, values};
use testkit::random::Random;

/// States at which errors are measured.
const STATES: usize = 500;

/// q, qd, qdd.
pub type State<const N: usize> = Numbers<f64, N>;

/// Random states: positions within pi, velocities within 3 rad/s, accelerations within 10 rad/s^2.
pub fn states<const N: usize>() -> Vec<State<N>> {
    let mut random = Random::seeded(0);
    let state = |_| [std::f64::consts::PI, 3.0, 10.0].map(|limit| random.vector(limit));
    (0..STATES).map(state).collect()
}

/// The largest difference of each function from the whole arm's over the largest value of that. Accelerations are those
/// under the whole arm's torques.
pub fn errors<const N: usize>(part: &impl Five<N>, whole: &impl Five<N>) -> [f64; 5] {
    let states = states::<N>();
    let forced: Vec<State<N>> = states
        .iter()
        .map(|&[q, qd, qdd]| [q, qd, whole.inverse_dynamics(&q, &qd, &qdd)])
        .collect();
    std::array::from_fn(|function| {
        let states = if function == 4 { &forced } else { &states };
        let (part, whole) = (
            values(part, function, states),
            values(whole, function, states),
        );
        let (mut difference, mut size) = (0.0_f64, 0.0_f64);
        for (a, b) in part.iter().flatten().zip(whole.iter().flatten()) {
            difference = difference.max((a - b).abs());
            size = size.max(b.abs());
        }
        difference / size
    })
}

/// Nanoseconds of a call of each function: medians over all states.
pub fn times<const N: usize>(arm: &impl Five<N>) -> [f64; 5] {
    let states = states::<N>();
    std::array::from_fn(|function| {
        let [time] = Effort::FULL.in_turns([&mut || calls(arm, function, &states)]);
        time / STATES as f64
    })
}

/// Multiplications, additions and divisions of each function.
pub fn operations(all: &[(&str, Operations)]) -> [u32; 5] {
    NAMES.map(|function| {
        let found = all.iter().find(|(name, _)| *name == function);
        found.map_or(0, |(_, operations)| operations.total())
    })
}

/// Nanoseconds of a call of a function that only some arms have.
pub fn time<const N: usize, R>(call: impl Fn(&State<N>) -> R) -> f64 {
    Effort::FULL.nanoseconds(&states::<N>(), call)
}
