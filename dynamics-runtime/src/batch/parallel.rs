//! The states of a batch over all cores.

use fearless_simd::Level;

use super::function::Function;
use super::layout::Sink;
use super::run::{Arguments, Failure, run, states};
use super::{LengthMismatch, layout::MOST_LANES};

/// So many states are evaluated on one core: some ten microseconds of work, many times what it
/// takes to hand them to another.
const LEAST: usize = 512;

/// A function at every state, on all cores.
pub(super) fn each<F, R, A, O, const N: usize, const K: usize, const C: usize>(
    robot: &R,
    arguments: A,
    results: O,
) -> Result<Failure, LengthMismatch>
where
    F: Function<R, N, K, C>,
    R: Sync,
    A: Arguments<N, K>,
    O: Sink<N, C>,
{
    let states = states::<F, R, N, K, C>(&arguments, &results)?;
    Ok(halves::<F, R, A, O, N, K, C>(
        Level::new(),
        robot,
        arguments,
        results,
        states,
    ))
}

/// One half here, the other wherever there is a free core; and so each half.
fn halves<F, R, A, O, const N: usize, const K: usize, const C: usize>(
    level: Level,
    robot: &R,
    arguments: A,
    results: O,
    states: usize,
) -> Failure
where
    F: Function<R, N, K, C>,
    R: Sync,
    A: Arguments<N, K>,
    O: Sink<N, C>,
{
    if states < 2 * LEAST {
        return run::<F, R, A, O, N, K, C>(level, robot, arguments, results, states);
    }
    let middle = (states / 2).next_multiple_of(MOST_LANES);
    let (left, right) = arguments.split(middle);
    let (left_results, right_results) = results.split(middle);
    let rest = states - middle;
    let (left, right) = rayon::join(
        move || halves::<F, R, A, O, N, K, C>(level, robot, left, left_results, middle),
        move || halves::<F, R, A, O, N, K, C>(level, robot, right, right_results, rest),
    );
    left.or(right.map(|(state, error)| (middle + state, error)))
}
