//! The last descent of a search that found nothing: to the very bottom, where the targets are as near as they come.

use super::descent::{Descent, End, LEAST_DAMPING, greatest};
use super::joints::Joints;
use super::normal::Normal;
use super::step::Damped;
use crate::size::Size;

const MOST_STEPS: usize = 500;

/// A step that gains less, as a share of the error, is not made.
const LEAST_GAIN: f64 = 1e-9;

/// Where steps so short gain nothing, as a share of the greatest diagonal entry of J'J, this is the bottom.
const MOST_DAMPING: f64 = 1e9;

/// Goes down from `start`, and never up: a step to a greater error is not made, and the next one is damped more.
pub(super) fn settle<D: Size>(
    joints: &Joints<D>,
    normal_at: impl Fn(&D::Vector) -> Normal<D>,
    start: D::Vector,
) -> Descent<D> {
    let (mut q, mut normal) = (start.clone(), normal_at(&start));
    let greatest = greatest(joints.size, &normal.matrix);
    let mut damping = 0.1 * greatest;
    let mut iterations = 0;
    let end = loop {
        if normal.is_reached {
            break End::Reached;
        }
        if !normal.error.is_finite() {
            break End::NonFinite;
        }
        if iterations == MOST_STEPS {
            break End::Iterations;
        }
        let pull = None;
        let step = Damped {
            normal: &normal,
            damping,
            pull,
        };
        let next = step
            .stepped(joints, &q)
            .filter(|_| damping < MOST_DAMPING * greatest);
        let Some(next) = next else {
            break End::Stuck;
        };
        iterations += 1;
        let there = normal_at(&next);
        let gain = normal.error - there.error;
        if gain < LEAST_GAIN * normal.error {
            damping *= 4.0;
        } else {
            (q, normal) = (next, there);
            damping = (damping / 4.0).max(LEAST_DAMPING * greatest);
        }
    };
    let error = normal.error;
    Descent {
        q,
        error,
        iterations,
        end,
    }
}
