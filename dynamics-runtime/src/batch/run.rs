//! The loop over the groups of states that fill a vector register.
//!
//! Everything between the choice of instructions and the arithmetic must be inlined, or it would be compiled without
//! them:
//!
//! - Programs stand in `#[inline(always)]` methods of traits, and the struct's own methods call them. The programs of
//!   M, V, G, tau and qdd are in `MassMatrix` to `ForwardDynamics`, which arms written by hand have too. All others are
//!   in `Function<F, N>`, where `F` is a type for each function.
//! - No batch calls the struct's own methods, which from forty operations on are `#[inline(never)]`. Inlined, a
//!   program stood in every caller: the compiler took 22 times as long for a function with 24 places of calls as for
//!   one with one. In a loop over states a call takes 1 % more time. The methods of a `SharedSines` stay inlined.
//! - `map` and `from_fn` of arrays are not used on lanes, nor loops that the compiler may leave rolled: arrays that
//!   stay arrays live in memory.
//! - `Wide<S>` can be made from nothing only by asking the processor again, so that programs make their constants by
//!   `Scalar::constant` in the arithmetic of an argument.
//!
//! A batch is checked and put together where it is called (`Task::new` is inlined). Slices that were just written one
//! by one and are read as vectors make a processor wait. That took half of the time of 64 states of a short function.
//!
//! A group with a state that has no accelerations is evaluated again state by state. The last group overlaps the one
//! before it. Fewer states than lanes are copied and filled up with the last one, never with zeros, which may be
//! singular.

use core::marker::PhantomData;

use fearless_simd::{Level, Simd, dispatch};

use super::LengthMismatch;
use super::arms::Arms;
use super::layout::{Sink, Source};
use super::wide::{Precision, Wide, lanes};
use crate::function::{Arrangement, Function, Of};
use crate::inputs::Evaluated;
use crate::{Scalar, SingularMassMatrix};

/// A state without a value, and why.
pub(super) type Failure = Option<(usize, SingularMassMatrix)>;

/// A function of robots `R` with `N` joints, the arms and the arguments that it is to be evaluated at, and room for its
/// values, as numbers of type `E`. Arguments and results are not copied: a processor waits for numbers just written.
pub(super) struct Task<'t, R, E, F, B, A, O, const N: usize> {
    kind: PhantomData<fn() -> (R, E)>,
    pub(super) function: F,
    pub(super) arms: B,
    pub(super) arguments: &'t A,
    pub(super) results: &'t mut O,
    pub(super) states: usize,
}

/// The values of a function, in an arithmetic.
type Value<R, F, const N: usize, T> = Of<<R as Function<F, N>>::Values, T>;

impl<'t, R, E, F, B, A, O, const N: usize> Task<'t, R, E, F, B, A, O, N>
where
    R: Function<F, N>,
    E: Precision,
    F: Copy,
    B: Arms<R>,
    A: Source<R::Arguments, E>,
    O: Sink<R::Values, E>,
{
    /// The task, if all arguments, the arms and the results agree on the number of states: that of the
    /// first of them.
    ///
    /// Inlined into the method of a batch, so that the slices go to memory one number at a time: a processor waits
    /// about ten nanoseconds before it reads a vector that was just written in parts.
    #[inline(always)]
    pub(super) fn new(
        function: F,
        arms: B,
        arguments: &'t A,
        results: &'t mut O,
    ) -> Result<Self, LengthMismatch> {
        let (mut expected, mut mismatch) = (None, None);
        let mut compare = |argument, states: usize| {
            let expected = *expected.get_or_insert(states);
            if states != expected && mismatch.is_none() {
                mismatch = Some(LengthMismatch {
                    argument,
                    found: states,
                    expected,
                });
            }
        };
        let mut names = R::ARGUMENTS.iter();
        arguments.states(&mut |states, other| {
            let name = names.next().copied().unwrap_or_default();
            compare(name, states);
            compare(name, other.unwrap_or(states));
        });
        if let Some(states) = arms.states() {
            compare("parameters", states);
        }
        let (states, other) = results.states();
        compare(R::RESULT, states);
        compare(R::RESULT, other.unwrap_or(states));
        match mismatch {
            Some(mismatch) => Err(mismatch),
            None => Ok(Task::of(function, arms, arguments, results, states)),
        }
    }

    /// The task at so many states, which all parts of it have.
    #[inline(always)]
    pub(super) fn of(
        function: F,
        arms: B,
        arguments: &'t A,
        results: &'t mut O,
        states: usize,
    ) -> Self {
        Task {
            kind: PhantomData,
            function,
            arms,
            arguments,
            results,
            states,
        }
    }

    /// The function at every state, with the instructions of a level; the first state where it fails.
    #[inline(always)]
    pub(super) fn run(&mut self, level: Level) -> Failure {
        if self.states == 0 {
            return None;
        }
        if !R::IN_LANES {
            return self.in_turn();
        }
        if self.states >= E::MOST_LANES {
            return self.in_lanes(level);
        }
        self.padded(level)
    }

    /// Fewer states than lanes.
    #[inline(never)]
    fn padded(&mut self, level: Level) -> Failure {
        let (mut copies, mut values) = (A::room(), O::room());
        let arguments = self.arguments.padded(self.states, &mut copies);
        let mut results = O::elsewhere(&mut values);
        let (function, arms) = (self.function, self.arms);
        let mut full = Task::<R, E, _, _, _, _, N>::of(
            function,
            arms,
            &arguments,
            &mut results,
            E::MOST_LANES,
        );
        let failure = full.in_lanes(level);
        for state in 0..self.states {
            self.results.set(state, &results.state(state));
        }
        // A copy of the last state fails where that one does.
        failure
    }

    /// State by state, for functions without lanes.
    fn in_turn(&mut self) -> Failure {
        let mut failure = None;
        for state in 0..self.states {
            match Self::at(self.function, self.arms, self.arguments, state) {
                Ok(value) => self.results.set(state, &value),
                Err(error) => {
                    failure = failure.take().or(Some((state, error)));
                    let none = R::Values::filled(E::from_f64(f64::NAN));
                    self.results.set(state, &none);
                }
            }
        }
        failure
    }

    fn in_lanes(&mut self, level: Level) -> Failure {
        let (function, arms) = (self.function, self.arms);
        Self::vectorised(
            level,
            function,
            arms,
            self.arguments,
            self.results,
            self.states,
        )
    }

    /// Not a method: by what it is given the compiler knows that where the columns are is not written in the loop.
    #[inline(never)]
    fn vectorised(
        level: Level,
        function: F,
        arms: B,
        arguments: &A,
        results: &mut O,
        states: usize,
    ) -> Failure {
        dispatch!(level, simd => Self::groups(simd, function, arms, arguments, results, states))
    }

    /// The function in lanes. The last group overlaps the one before it where the lanes do not divide
    /// the states; there are at least as many states as lanes.
    #[inline(always)]
    fn groups<S: Simd>(
        simd: S,
        function: F,
        arms: B,
        arguments: &A,
        results: &mut O,
        states: usize,
    ) -> Failure {
        let last = states - lanes::<S, E>();
        let mut failure = None;
        let mut first = 0;
        loop {
            let group = arguments.load(simd, first);
            let inputs = arms.inputs::<S, E>(first);
            match R::at(arms.arm(first), function, &inputs, &group) {
                Ok(value) => results.store(first, &value),
                Err(_) => {
                    let (value, singular) = Self::one_by_one::<S>(function, arms, arguments, first);
                    results.store(first, &value);
                    failure = failure.or(singular);
                }
            }
            if first >= last {
                return failure;
            }
            first = last.min(first + lanes::<S, E>());
        }
    }

    /// A group in which a state fails: each by itself, so that none spoils another.
    #[cold]
    #[inline(never)]
    fn one_by_one<S: Simd>(
        function: F,
        arms: B,
        arguments: &A,
        first: usize,
    ) -> (Value<R, F, N, Wide<S, E>>, Failure) {
        let mut values = R::Values::filled(Wide::<S, E>::from_f64(f64::NAN));
        let mut failure = None;
        for lane in 0..lanes::<S, E>() {
            match Self::at(function, arms, arguments, first + lane) {
                Ok(value) => {
                    let set = |lanes: &mut Wide<S, E>, x| lanes.0[lane] = x;
                    R::Values::zip(&mut values, &value, set);
                }
                Err(error) => failure = failure.or(Some((first + lane, error))),
            }
        }
        (values, failure)
    }

    /// The function at a state, compiled once for all instruction sets.
    #[inline(never)]
    fn at(
        function: F,
        arms: B,
        arguments: &A,
        state: usize,
    ) -> Result<Value<R, F, N, E>, SingularMassMatrix> {
        let arguments = arguments.state(state);
        R::at(arms.arm(state), function, &Evaluated, &arguments).map_err(Into::into)
    }
}
