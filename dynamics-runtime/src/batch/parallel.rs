//! The states of a batch over all cores.

use fearless_simd::Level;

use super::arguments::Arguments;
use super::arms::Arms;
use super::layout::{MOST_LANES, Sink};
use super::run::{Failure, Task};
use super::wide::Precision;
use crate::function::Function;

/// So many operations are done on one core: some ten microseconds of work, many times what it
/// takes to hand them to another.
const LEAST_WORK: usize = 80_000;

impl<F, B, A, O> Task<F, B, A, O> {
    /// One half here, the other wherever there is a free core; and so each half.
    pub(super) fn halves<R, E, const N: usize>(mut self, level: Level) -> Failure
    where
        F: Copy + Send,
        R: Function<F, N>,
        E: Precision,
        B: Arms<R> + Send,
        A: Arguments<R::Arguments, E>,
        O: Sink<R::Values, E>,
    {
        let least = LEAST_WORK / (R::WORK as usize).max(1);
        if self.states < 2 * least.max(MOST_LANES) {
            return self.run::<R, E, N>(level);
        }
        let middle = (self.states / 2).next_multiple_of(MOST_LANES);
        let (arguments, other_arguments) = self.arguments.split(middle);
        let (arms, other_arms) = self.arms.split(middle);
        let first = Task {
            function: self.function,
            arms,
            arguments,
            results: self.results.take(middle),
            states: middle,
        };
        let others = Task {
            function: self.function,
            arms: other_arms,
            arguments: other_arguments,
            results: self.results,
            states: self.states - middle,
        };
        let (first, others) = rayon::join(
            move || first.halves::<R, E, N>(level),
            move || others.halves::<R, E, N>(level),
        );
        first.or(others.map(|(state, error)| (middle + state, error)))
    }
}
