//! How large an error and a step may be.

use super::{Failure, Phase};
use crate::size::Size;

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
    /// The step of the range that is nearest to one that is wished for.
    ///
    /// The shortest is tried before a run ends for want of a short one: steps shorter than it, good
    /// as they may be, never arrive.
    pub(super) fn within(&self, wish: f64) -> f64 {
        wish.max(self.least).min(self.greatest)
    }

    /// Why no step of the range was good, of which the shortest failed so, where the motion asked for steps of length
    /// `wish` at its start.
    ///
    /// What was wrong with the equations is told where steps could be that short. Where none can, it was met at stages
    /// far beyond what the motion reaches.
    pub(super) fn judge<E>(&self, failure: Failure<E>, wish: f64) -> Failure<E> {
        match self.least > wish {
            true => Failure::StepTooSmall,
            false => failure,
        }
    }
}
