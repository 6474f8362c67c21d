//! How large an error and a step may be.

use dynamics_runtime::Size;

use super::{Failure, Phase};

/// Error bounds: a step's error in an entry y may be `absolute + relative |y|`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance {
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

impl Tolerance {
    /// Root mean square of the entries, each over its bound at the larger of two phases (Hairer,
    /// Nørsett, Wanner I, (II.4.11)).
    pub(super) fn norm<D: Size>(&self, error: &Phase<D>, from: &Phase<D>, to: &Phase<D>) -> f64 {
        let entries = error.entries().zip(from.entries().zip(to.entries()));
        let squares = entries.map(|(error, (from, to))| {
            let bound = self.absolute + self.relative * from.abs().max(to.abs());
            (error / bound).powi(2)
        });
        (squares.sum::<f64>() / (2 * error.size().value()) as f64).sqrt()
    }
}

/// Bounds of the step size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepRange {
    pub(crate) least: f64,
    pub(crate) greatest: f64,
}

impl StepRange {
    /// The length of the next step, and whether it is the last, where one is wished for and a way is left.
    ///
    /// The shortest of the range is tried before a run fails: shorter steps never arrive. Rather a step longer by a
    /// hundredth than a tiny one after it.
    pub(super) fn choose(&self, wish: f64, left: f64) -> (f64, bool) {
        let step = wish.max(self.least).min(self.greatest);
        let is_last = 1.01 * step >= left;
        (if is_last { left } else { step }, is_last)
    }

    /// The reason that no step of the range was good, where the shortest failed, and the motion needed steps of
    /// length `wish` at its start.
    ///
    /// A refusal of the equations counts where steps could be that short. Where none can, it was met at stages far beyond
    /// the states that the motion reaches.
    pub(super) fn judge<E>(&self, failure: Failure<E>, wish: f64) -> Failure<E> {
        if self.least > wish {
            Failure::StepTooSmall
        } else {
            failure
        }
    }
}
