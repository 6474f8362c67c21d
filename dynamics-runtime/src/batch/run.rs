//! The loop over the groups of states that fill a vector register.

use fearless_simd::{Level, Simd, SimdBase, dispatch};
use nalgebra::{SMatrix, SVector};

use super::LengthMismatch;
use super::function::Function;
use super::layout::{MOST_LANES, Sink, Source};
use super::wide::Wide;
use crate::SingularMassMatrix;

/// The arguments of a function of `K` vectors: see [`Source`].
pub(crate) trait Arguments<const N: usize, const K: usize>: Copy + Send {
    type Room;
    type Copied<'r>: Arguments<N, K>
    where
        Self: 'r;

    fn states(&self) -> [(usize, Option<usize>); K];
    fn shorten(&mut self, states: usize);
    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self);
    fn state(&self, state: usize) -> [SVector<f64, N>; K];
    fn room() -> Self::Room;
    fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Self::Copied<'r>
    where
        Self: 'r;
    fn load<S: Simd>(&self, simd: S, first: usize) -> [SVector<Wide<S>, N>; K];
}

macro_rules! impl_arguments {
    ($arity:literal: $($source:ident $x:ident $y:ident),*) => {
        impl<$($source: Source<N>,)* const N: usize> Arguments<N, $arity> for ($($source,)*) {
            type Room = ($($source::Room,)*);
            type Copied<'r> = ($($source::Copied<'r>,)*) where Self: 'r;

            fn states(&self) -> [(usize, Option<usize>); $arity] {
                let ($($x,)*) = self;
                [$($x.states()),*]
            }

            #[inline(always)]
            fn shorten(&mut self, states: usize) {
                let ($($x,)*) = self;
                $($x.shorten(states);)*
            }

            #[cfg(feature = "rayon")]
            fn split(self, states: usize) -> (Self, Self) {
                let ($($x,)*) = self;
                $(let ($x, $y) = $x.split(states);)*
                (($($x,)*), ($($y,)*))
            }

            #[inline]
            fn state(&self, state: usize) -> [SVector<f64, N>; $arity] {
                let ($($x,)*) = self;
                [$($x.state(state)),*]
            }

            fn room() -> Self::Room {
                ($($source::room(),)*)
            }

            fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Self::Copied<'r>
            where
                Self: 'r,
            {
                let (($($x,)*), ($($y,)*)) = (self, room);
                ($($x.padded(states, $y),)*)
            }

            #[inline(always)]
            fn load<S: Simd>(&self, simd: S, first: usize) -> [SVector<Wide<S>, N>; $arity] {
                let ($($x,)*) = self;
                [$($x.load(simd, first)),*]
            }
        }
    };
}

impl_arguments!(1: A a x);
impl_arguments!(2: A a x, B b y);
impl_arguments!(3: A a x, B b y, C c z);

/// A state without accelerations, and why.
pub(super) type Failure = Option<(usize, SingularMassMatrix)>;

/// The number of states, if all arguments and the results agree on it.
pub(super) fn states<F, R, const N: usize, const K: usize, const C: usize>(
    arguments: &impl Arguments<N, K>,
    results: &impl Sink<N, C>,
) -> Result<usize, LengthMismatch>
where
    F: Function<R, N, K, C>,
{
    let arguments = arguments.states();
    let (expected, _) = arguments[0];
    let named = F::ARGUMENTS.into_iter().zip(arguments);
    for (argument, (states, other)) in named.chain([(F::RESULT, results.states())]) {
        let lengths = [Some(states), other];
        if let Some(found) = lengths.into_iter().flatten().find(|&n| n != expected) {
            return Err(LengthMismatch {
                argument,
                found,
                expected,
            });
        }
    }
    Ok(expected)
}

/// The function at every state, with the instructions of a level; the first state where it fails.
pub(crate) fn run<F, R, A, O, const N: usize, const K: usize, const C: usize>(
    level: Level,
    robot: &R,
    arguments: A,
    mut results: O,
    states: usize,
) -> Failure
where
    F: Function<R, N, K, C>,
    A: Arguments<N, K>,
    O: Sink<N, C>,
{
    if states == 0 || N == 0 {
        return None;
    }
    if states >= MOST_LANES {
        return vectorised::<F, R, A, O, N, K, C>(level, robot, arguments, results, states);
    }
    let (mut copies, mut values) = (A::room(), O::room());
    let copies = arguments.padded(states, &mut copies);
    let filled = results.elsewhere(&mut values);
    let failure = vectorised::<F, R, _, _, N, K, C>(level, robot, copies, filled, MOST_LANES);
    let filled = results.elsewhere(&mut values);
    for state in 0..states {
        results.set(state, &filled.state(state));
    }
    failure
}

fn vectorised<F, R, A, O, const N: usize, const K: usize, const C: usize>(
    level: Level,
    robot: &R,
    arguments: A,
    results: O,
    states: usize,
) -> Failure
where
    F: Function<R, N, K, C>,
    A: Arguments<N, K>,
    O: Sink<N, C>,
{
    dispatch!(level, simd => groups::<F, R, A, O, _, N, K, C>(simd, robot, arguments, results, states))
}

/// The function in lanes. The last group overlaps the one before it where the lanes do not divide
/// the states; there are at least as many states as lanes.
#[inline(always)]
fn groups<F, R, A, O, S, const N: usize, const K: usize, const C: usize>(
    simd: S,
    robot: &R,
    mut arguments: A,
    mut results: O,
    states: usize,
) -> Failure
where
    F: Function<R, N, K, C>,
    A: Arguments<N, K>,
    O: Sink<N, C>,
    S: Simd,
{
    // All of one length in the compiler's eyes too: one comparison for each group.
    arguments.shorten(states);
    results.shorten(states);
    let last = states - S::f64s::LEN;
    let mut failure = None;
    let mut first = 0;
    loop {
        let group = arguments.load(simd, first);
        match F::at(robot, &group) {
            Ok(value) => results.store(first, &value),
            Err(_) => {
                let (value, singular) =
                    one_by_one::<F, R, A, S, N, K, C>(simd, robot, arguments, first);
                results.store(first, &value);
                failure = failure.or(singular);
            }
        }
        if first >= last {
            return failure;
        }
        first = last.min(first + S::f64s::LEN);
    }
}

/// A group in which a state fails: each by itself, so that none spoils another.
#[cold]
#[inline(never)]
fn one_by_one<F, R, A, S, const N: usize, const K: usize, const C: usize>(
    simd: S,
    robot: &R,
    arguments: A,
    first: usize,
) -> (SMatrix<Wide<S>, N, C>, Failure)
where
    F: Function<R, N, K, C>,
    A: Arguments<N, K>,
    S: Simd,
{
    let mut values = SMatrix::<Wide<S>, N, C>::repeat(Wide(S::f64s::splat(simd, f64::NAN)));
    let mut failure = None;
    for lane in 0..S::f64s::LEN {
        match at::<F, R, N, K, C>(robot, &arguments.state(first + lane)) {
            Ok(value) => {
                values.zip_apply(&value, |lanes: &mut Wide<S>, x| lanes.0[lane] = x);
            }
            Err(error) => failure = failure.or(Some((first + lane, error))),
        }
    }
    (values, failure)
}

/// The function at a state, compiled once for all instruction sets.
#[inline(never)]
fn at<F, R, const N: usize, const K: usize, const C: usize>(
    robot: &R,
    arguments: &[SVector<f64, N>; K],
) -> Result<SMatrix<f64, N, C>, SingularMassMatrix>
where
    F: Function<R, N, K, C>,
{
    F::at(robot, arguments)
}
