//! The trajectories of `tests/data`.

use robot_dynamics::Trajectory;
use robot_dynamics::nalgebra::SVector;
use serde::Deserialize;

use super::Decimal;

/// Samples of a motion: `y` holds the positions, then the velocities.
#[derive(Deserialize)]
pub struct MotionFile {
    /// A sample each: positions, then velocities.
    pub y: Vec<Vec<Decimal>>,
    /// The largest change of each sample by a unit change of the initial state.
    #[serde(default)]
    pub sensitivity_per_sample: Vec<f64>,
}

impl MotionFile {
    /// The motion's initial state.
    pub fn initial<const N: usize>(&self) -> (SVector<f64, N>, SVector<f64, N>) {
        let state = |i: usize| self.y[0][i].nearest();
        (
            SVector::from_fn(|i, _| state(i)),
            SVector::from_fn(|i, _| state(N + i)),
        )
    }

    /// The largest error of each sample of a simulated motion.
    ///
    /// # Panics
    ///
    /// Where it has another number of samples.
    pub fn errors<const N: usize>(&self, motion: &Trajectory<N>) -> Vec<f64> {
        assert_eq!(motion.len(), self.y.len());
        let states = motion.q.iter().zip(&motion.qd).zip(&self.y);
        let error = |((q, qd), exact): ((&SVector<f64, N>, &SVector<f64, N>), &Vec<Decimal>)| {
            let state = q.iter().chain(qd.iter());
            let errors = state.zip(exact).map(|(x, exact)| exact.error_of(*x).abs());
            errors.fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
        };
        states.map(error).collect()
    }
}

/// Positions, velocities, accelerations and torques along a trajectory.
#[derive(Deserialize)]
pub struct TorqueFile {
    /// Times, s.
    pub t: Vec<f64>,
    /// A row for each time.
    pub rows: Vec<Vec<Decimal>>,
}
