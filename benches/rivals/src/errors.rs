//! Errors against the references of 25 digits, relative to each quantity's natural magnitude.

use robot_dynamics::State;
use robot_dynamics::nalgebra::SVector;
use testkit::references::{Decimal, ReferenceFile, ReferenceState, read};

use crate::candidates::{Candidate, Values};

/// The largest error of a function, and the root of the mean of the squares.
#[derive(Clone, Copy, Default)]
pub(crate) struct Errors {
    pub(crate) largest: f64,
    squares: f64,
    count: usize,
}

impl Errors {
    fn add(&mut self, error: f64, scale: f64) {
        // An arm at rest has no V: both are zero.
        let relative = if error == 0.0 {
            0.0
        } else {
            (error / scale).abs()
        };
        self.largest = self.largest.max(relative);
        self.squares += relative * relative;
        self.count += 1;
    }

    pub(crate) fn rms(&self) -> f64 {
        (self.squares / self.count as f64).sqrt()
    }
}

/// The errors of the five functions over the states of the arm's file, angles of 1e6 rad among
/// them, in the order of [`testkit::five::NAMES`].
pub(crate) fn errors<const N: usize, C: Candidate<N>>(
    file: &str,
    candidate: &mut C,
) -> [Errors; 5] {
    let reference: ReferenceFile = read("reference", file);
    let mut errors = [Errors::default(); 5];
    for state in &reference.states {
        let torque: Vec<Decimal> = (0..N).map(|i| state.tau[i] + state.friction[i]).collect();
        let applied = SVector::from_fn(|i, _| torque[i].nearest());
        let values = candidate.values(&at(state), &applied);
        add(&mut errors, &values, state, &torque);
    }
    errors
}

fn at<const N: usize>(state: &ReferenceState) -> State<N> {
    State {
        q: SVector::from_row_slice(&state.q),
        qd: SVector::from_row_slice(&state.qd),
        qdd: SVector::from_row_slice(&state.qdd),
    }
}

fn add<const N: usize>(
    errors: &mut [Errors; 5],
    values: &Values<N>,
    reference: &ReferenceState,
    torque: &[Decimal],
) {
    let [inverse, mass, coriolis, gravity, forward] = errors;
    let scale = &reference.scale;
    let largest_torque = torque.iter().map(|t| t.nearest().abs());
    let scale_of_torque = largest_torque.fold(scale.tau, f64::max);
    for i in 0..N {
        let error = |x: f64, exact: &Decimal| exact.error_of(x);
        inverse.add(
            error(values.inverse_dynamics[i], &torque[i]),
            scale_of_torque,
        );
        coriolis.add(
            error(values.coriolis_vector[i], &reference.coriolis_vector[i]),
            scale.V,
        );
        gravity.add(
            error(values.gravity_vector[i], &reference.gravity_vector[i]),
            scale.G,
        );
        // Accelerations are judged by the torques that they need beyond those that were applied.
        let mut needed = -torque[i].error_of(torque[i].nearest());
        for j in 0..N {
            let entry = &reference.mass_matrix[i][j];
            mass.add(error(values.mass_matrix[(i, j)], entry), scale.M);
            needed += entry.nearest() * (values.forward_dynamics[j] - reference.qdd[j]);
        }
        forward.add(needed, scale_of_torque);
    }
}
