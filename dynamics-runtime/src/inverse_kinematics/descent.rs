//! One descent: to positions at which all targets are reached, or to a place from which no joint gets nearer.
//!
//! A step solves (J'J + damping) dq = J'e (`step`, with sums over all targets from `normal`). The error of a rotation
//! is 2 sin(angle / 2) along its axis (`target`), whose square is smooth everywhere. Half a turn has a case of its
//! own, because the sines vanish there and zero would be a success. Joints that would pass a limit are put on it and
//! the others solved for anew. Steps are made without asking whether the error falls, and end if five of them do not
//! halve it. `settle`, the last descent of a search that found nothing, never goes up. Success is
//! `Normal::is_reached` at the very positions that are returned, whole turns taken off.

use super::joints::Joints;
use super::normal::Normal;
use super::step::Damped;
use crate::size::Size;

/// The share of the error in the damping (T. Sugihara, *Solvability-unconcerned inverse kinematics by the
/// Levenberg-Marquardt method*, IEEE Trans. Robotics 27 (2011), 984-991, who adds all of it): far from the targets steps are
/// short, near them they are those of Gauss and Newton. A tenth solves the Panda faster than 0.01, 1 and 10.
const DAMPING_OF_ERROR: f64 = 0.1;

/// The least damping, as a share of the greatest diagonal entry of J'J: it keeps joints still that move nothing.
pub(super) const LEAST_DAMPING: f64 = 1e-12;

/// After so many iterations the error is compared with that before them.
const PERIOD: usize = 5;

/// When a descent ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Patience {
    pub(super) iterations: usize,
    /// It ends where the error is not below this share of that before [`PERIOD`] iterations.
    pub(super) share: f64,
}

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

/// Goes down from `start`, which is within the limits.
#[inline]
pub(super) fn descend<D: Size>(
    joints: &Joints<D>,
    patience: Patience,
    normal_at: impl Fn(&D::Vector) -> Normal<D>,
    start: &D::Vector,
) -> Descent<D> {
    let mut q = start.clone();
    let mut before = f64::INFINITY;
    let mut iterations = 0;
    loop {
        let normal = normal_at(&q);
        let checks = iterations % PERIOD == PERIOD - 1;
        let next = || damped(joints.size, &normal).stepped(joints, &q);
        let found = if normal.is_reached {
            Err(End::Reached)
        } else if !normal.error.is_finite() {
            Err(End::NonFinite)
        } else if checks && normal.error >= patience.share * before {
            Err(End::Stuck)
        } else if iterations == patience.iterations {
            Err(End::Iterations)
        } else {
            next().ok_or(End::Stuck)
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

#[inline(always)]
fn damped<D: Size>(size: D, normal: &Normal<D>) -> Damped<'_, D> {
    let greatest = greatest(size, &normal.matrix);
    // Where the targets are farther away than the arm is long, a longer way damps no more.
    let of_error = DAMPING_OF_ERROR * normal.error.min(greatest);
    Damped {
        normal,
        damping: of_error + LEAST_DAMPING * greatest,
        pull: None,
    }
}

/// The greatest diagonal entry.
#[inline(always)]
pub(super) fn greatest<D: Size>(size: D, matrix: &D::Matrix) -> f64 {
    size.joints()
        .fold(0.0, |most: f64, joint| most.max(matrix[(joint, joint)]))
}
