//! The search for positions at which what is left of M is not positive definite.

use super::arm::Arm;
use super::sample::{Samples, ranges};
use super::{SMALLEST_PIVOT, least_relative_pivot, sum_of};
use crate::mechanism::Mechanism;

/// Samples to start from: the worst ones.
const STARTS: usize = 8;

/// Rounds over the joints with one length of step.
const ROUNDS: usize = 40;

/// Steps begin with an eighth of a joint's range, and are halved so many times.
const HALVINGS: usize = 12;

/// Positions found by stepping along one joint after the other, to where the least pivot falls.
pub(super) fn indefinite(
    mechanism: &Mechanism,
    arm: &Arm,
    samples: &Samples,
    is_kept: &[bool],
) -> Option<Vec<f64>> {
    let ranges = ranges(mechanism);
    let least = |q: &[f64]| least_relative_pivot(sum_of(&arm.mass_matrix(q), is_kept));
    let starts = samples.q.iter().map(|q| (least(q), q.clone()));
    let mut starts: Vec<_> = starts.collect();
    starts.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let mut descents = starts.into_iter().take(STARTS).map(|(mut value, mut q)| {
        let mut fraction = 0.125;
        for _ in 0..HALVINGS {
            for _ in 0..ROUNDS {
                if value <= SMALLEST_PIVOT || !step(&mut q, &mut value, &ranges, fraction, least) {
                    break;
                }
            }
            fraction *= 0.5;
        }
        (value, q)
    });
    let found = descents.find(|(value, _)| *value <= SMALLEST_PIVOT);
    found.map(|(_, q)| q)
}

/// Moves each joint by a fraction of its range where that makes `least` fall; whether any moved.
fn step(
    q: &mut [f64],
    value: &mut f64,
    ranges: &[[f64; 2]],
    fraction: f64,
    least: impl Fn(&[f64]) -> f64,
) -> bool {
    let mut has_moved = false;
    for (i, [lower, upper]) in ranges.iter().enumerate() {
        for sign in [-1.0, 1.0] {
            let old = q[i];
            let moved = old + sign * fraction * (upper - lower);
            q[i] = moved.max(*lower).min(*upper);
            let moved = least(q);
            if moved < *value {
                *value = moved;
                has_moved = true;
            } else {
                q[i] = old;
            }
        }
    }
    has_moved
}
