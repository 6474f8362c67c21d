//! The systems of the lecture notes and textbooks that this project reproduces.

mod aborted_runs;
mod check;
mod contract;
mod degenerate;
mod fused;
mod identification;
mod integration;
mod masses;
mod names;
mod one_link;
mod shared_sines;
mod solids;
mod taylor;
mod tool_wrench;
mod two_link_point_masses;
mod two_link_rods;

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{Method, Trajectory, simulation::DormandPrince};
use testkit::references::MotionFile;

/// The largest difference of a computed value from the true one, relative to its magnitude: 18 roundings.
const TOLERANCE: f64 = 4e-15;

/// Asserts that two numbers agree relative to `magnitude`.
#[track_caller]
fn assert_near(found: f64, expected: f64, magnitude: f64) {
    within(found - expected, magnitude);
}

/// Asserts that an error is small relative to `magnitude`.
#[track_caller]
fn within(error: f64, magnitude: f64) {
    let bound = TOLERANCE * magnitude.abs();
    assert!(error.abs() <= bound, "{error:e} is beyond {bound:e}");
}

/// Asserts that two vectors agree relative to `magnitude`.
#[track_caller]
fn assert_all_near<const N: usize>(found: SVector<f64, N>, expected: [f64; N], magnitude: f64) {
    for (found, expected) in found.iter().zip(expected) {
        assert_near(*found, expected, N as f64 * magnitude);
    }
}

/// Dormand and Prince's method at a tolerance of 1e-12 for each step.
fn precise() -> Method {
    Method::DormandPrince(DormandPrince::with_tolerance(1e-12))
}

/// Asserts that a motion integrated by [`precise`] is that of the file: the errors of about a
/// thousand steps, each grown by the sensitivity of the motion.
#[track_caller]
fn assert_same_motion<const N: usize>(motion: &Trajectory<N>, file: &MotionFile) {
    let errors = file.errors(motion);
    for ((error, growth), t) in errors
        .iter()
        .zip(&file.sensitivity_per_sample)
        .zip(&motion.t)
    {
        let bound = 1_000.0 * 1e-12 * growth.max(1.0);
        assert!(*error <= bound, "t = {t}: {error:e} is beyond {bound:e}");
    }
    assert_eq!(file.sensitivity_per_sample.len(), errors.len());
}

/// The largest number, NaN where there is one.
fn largest(errors: &[f64]) -> f64 {
    errors
        .iter()
        .fold(0.0, |a, b| if *b > a || b.is_nan() { *b } else { a })
}
