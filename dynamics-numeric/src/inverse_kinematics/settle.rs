//! The last descent of a search that found nothing: to the very bottom, where the targets are as near as they come.

use dynamics_runtime::Size;

use super::descent::{Descent, End, LEAST_DAMPING};
use super::places::Places;
use super::problem::Problem;

const MOST_STEPS: usize = 500;

/// A step that gains less, as a share of the error, is not made.
const LEAST_GAIN: f64 = 1e-9;

/// Where steps so short gain nothing, as a share of the greatest diagonal entry of J'J, this is the bottom.
const MOST_DAMPING: f64 = 1e9;

impl<D: Size, P: Places<D>> Problem<'_, D, P> {
    /// Goes down from `q`, and never up: a step to a greater error is not made, and the next one is damped more.
    pub(super) fn settle(&self, mut q: D::Vector) -> Descent<D> {
        let mut normal = self.normal_at(&q);
        let greatest = normal.greatest();
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
            let next = normal.stepped(self.joints, damping, None, &q);
            let Some(next) = next.filter(|_| damping < MOST_DAMPING * greatest) else {
                break End::Stuck;
            };
            iterations += 1;
            let there = self.normal_at(&next);
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
}
