//! One descent: to positions at which all targets are reached, or to a place from which no joint gets nearer.
//!
//! A step solves (J'J + damping) dq = J'e (`step`, with sums over all targets from `normal`). The error of a rotation
//! is 2 sin(angle / 2) along its axis (`target`), whose square is smooth everywhere. Half a turn has a case of its
//! own, because the sines vanish there and zero would be a success. Joints that would pass a limit are put on it and
//! the others solved for anew. Steps are made without asking whether the error falls, and end if five of them do not
//! halve it. `settle`, the last descent of a search that found nothing, never goes up. Success is
//! `Normal::is_reached` at the very positions that are returned, whole turns taken off.

use dynamics_runtime::Size;

use super::places::Places;
use super::problem::Problem;

/// The share of the error in the damping (T. Sugihara, *Solvability-unconcerned inverse kinematics by the
/// Levenberg-Marquardt method*, IEEE Trans. Robotics 27 (2011), 984-991, who adds all of it): far from the targets steps are
/// short, near them they are those of Gauss and Newton. A tenth solves the Panda faster than 0.01, 1 and 10.
const DAMPING_OF_ERROR: f64 = 0.1;

/// The least damping, as a share of the greatest diagonal entry of J'J: it keeps joints still that move nothing.
pub(super) const LEAST_DAMPING: f64 = 1e-12;

/// After so many iterations the error is compared with that before them.
const PERIOD: usize = 5;

/// A descent ends where the error is not below this share of that before: another one is more likely to reach the targets.
const SHARE: f64 = 0.5;

/// Why a descent ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum End {
    Reached,
    /// It no longer gets nearer.
    Stuck,
    /// Its iterations are used up.
    Iterations,
    /// The robot's functions gave numbers that are not finite.
    NonFinite,
}

/// Where a descent ended.
#[derive(Clone, Debug)]
pub(super) struct Descent<D: Size> {
    pub(super) q: D::Vector,
    pub(super) error: f64,
    pub(super) iterations: usize,
    pub(super) end: End,
}

impl<D: Size, P: Places<D>> Problem<'_, D, P> {
    /// Goes down from `q`, which is within the limits, in so many iterations at most.
    #[inline]
    pub(super) fn descend(&self, mut q: D::Vector, most: usize) -> Descent<D> {
        let mut before = f64::INFINITY;
        let mut iterations = 0;
        loop {
            let normal = self.normal_at(&q);
            let checks = iterations % PERIOD == PERIOD - 1;
            let found = if normal.is_reached {
                Err(End::Reached)
            } else if !normal.error.is_finite() {
                Err(End::NonFinite)
            } else if checks && normal.error >= SHARE * before {
                Err(End::Stuck)
            } else if iterations == most {
                Err(End::Iterations)
            } else {
                let greatest = normal.greatest();
                // Where the targets are farther away than the arm is long, a longer way damps no more.
                let of_error = DAMPING_OF_ERROR * normal.error.min(greatest);
                let damping = of_error + LEAST_DAMPING * greatest;
                let next = normal.stepped(self.joints, damping, None, &q);
                next.ok_or(End::Stuck)
            };
            match found {
                Ok(next) => q = next,
                Err(end) => {
                    let error = normal.error;
                    return Descent {
                        q,
                        error,
                        iterations,
                        end,
                    };
                }
            }
            if checks {
                before = normal.error;
            }
            iterations += 1;
        }
    }
}
