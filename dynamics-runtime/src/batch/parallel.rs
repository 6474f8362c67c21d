//! The states of a batch over all cores.
//!
//! The thread that calls begins at once, others take what is left, large shares at first and small ones at last, at
//! least 40,000 operations at a time. With `rayon::join` a thread that is none of rayon's would hand everything over
//! and sleep.

use core::hint::spin_loop;
use core::marker::PhantomData;
use core::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use fearless_simd::Level;
use rayon::Scope;

use super::LengthMismatch;
use super::arms::Arms;
use super::layout::{MOST_LANES, Sink, Source};
use super::run::{Failure, Task};
use super::wide::Precision;
use crate::function::Function;

/// The operations that one core does at a time: some five microseconds of work, many times that of fetching them.
const LEAST_WORK: usize = 40_000;

/// How often a thread without work looks whether the others are done, before it sleeps: for about ten microseconds,
/// less than it takes to wake up.
const MOST_LOOKS: usize = 1_000;

/// A function at every state, on all cores.
///
/// # Errors
///
/// Where lengths differ.
#[doc(hidden)]
pub fn on_all_cores<F, R, E, B, A, O, const N: usize>(
    function: F,
    arms: B,
    arguments: A,
    mut results: O,
) -> Result<Failure, LengthMismatch>
where
    F: Copy + Send,
    R: Function<F, N>,
    E: Precision,
    B: Arms<R> + Send,
    A: Source<R::Arguments, E>,
    O: Sink<R::Values, E>,
{
    let states = Task::<R, E, _, _, _, _, N>::new(function, arms, &arguments, &mut results)?.states;
    let all = Part::<R, E, _, _, _, _, N> {
        kind: PhantomData,
        function,
        arms,
        arguments,
        results,
        first: 0,
        states,
    };
    Ok(all.on_all_cores(Level::new()))
}

/// States that are evaluated together, with all that this takes.
struct Part<R, E, F, B, A, O, const N: usize> {
    kind: PhantomData<fn() -> (R, E)>,
    function: F,
    arms: B,
    arguments: A,
    results: O,
    /// The number of the first state among all.
    first: usize,
    states: usize,
}

impl<R, E, F, B, A, O, const N: usize> Part<R, E, F, B, A, O, N>
where
    R: Function<F, N>,
    E: Precision,
    F: Copy + Send,
    B: Arms<R> + Send,
    A: Source<R::Arguments, E>,
    O: Sink<R::Values, E>,
{
    /// The function at every state, on this core and on all that are free.
    fn on_all_cores(mut self, level: Level) -> Failure {
        let least = (LEAST_WORK / (R::WORK as usize).max(1)).max(MOST_LANES);
        let threads = rayon::current_num_threads().min(self.states / (2 * least));
        if threads < 2 {
            return self.run(level);
        }
        let shared = Shared {
            rest: Mutex::new(self),
            failure: Mutex::new(None),
            least,
            threads,
            at_work: AtomicUsize::new(threads - 1),
        };
        // `join` would hand all of the work to other threads if this one is none of rayon's. It begins at once.
        rayon::in_place_scope(|scope| {
            shared.work(scope, threads - 1, level);
            shared.await_others();
        });
        shared
            .failure
            .into_inner()
            .unwrap_or_else(PoisonError::into_inner)
    }

    /// The function at every state, on this core; the first state where it fails, by its number among all.
    fn run(&mut self, level: Level) -> Failure {
        let mut task = Task::<R, E, _, _, _, _, N>::of(
            self.function,
            self.arms,
            &self.arguments,
            &mut self.results,
            self.states,
        );
        let failure = task.run(level);
        failure.map(|(state, error)| (self.first + state, error))
    }

    /// The first states, which are a part of their own.
    fn take(&mut self, states: usize) -> Self {
        let (arguments, other_arguments) = self.arguments.split(states);
        let (arms, other_arms) = self.arms.split(states);
        let first = self.first;
        self.arguments = other_arguments;
        self.arms = other_arms;
        self.first += states;
        self.states -= states;
        Part {
            kind: PhantomData,
            function: self.function,
            arms,
            arguments,
            results: self.results.take(states),
            first,
            states,
        }
    }
}

/// States that several threads evaluate, each of which takes some whenever it has none.
struct Shared<R, E, F, B, A, O, const N: usize> {
    /// The states that no thread has taken yet.
    rest: Mutex<Part<R, E, F, B, A, O, N>>,
    failure: Mutex<Failure>,
    /// The fewest states that a thread takes at a time.
    least: usize,
    threads: usize,
    /// The number of other threads that have not come to the end.
    at_work: AtomicUsize,
}

impl<R, E, F, B, A, O, const N: usize> Shared<R, E, F, B, A, O, N>
where
    R: Function<F, N>,
    E: Precision,
    F: Copy + Send,
    B: Arms<R> + Send,
    A: Source<R::Arguments, E>,
    O: Sink<R::Values, E>,
{
    /// Takes states until there are none left, beside so many other threads, each of which wakes up half of those
    /// that it is given.
    fn work<'s>(&'s self, scope: &Scope<'s>, mut others: usize, level: Level) {
        while others > 0 {
            let of_other = others / 2;
            scope.spawn(move |scope| {
                self.work(scope, of_other, level);
                self.at_work.fetch_sub(1, Ordering::Release);
            });
            others -= of_other + 1;
        }
        while let Some(mut part) = self.next() {
            if let Some((state, error)) = part.run(level) {
                let mut failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner);
                if failure.as_ref().is_none_or(|(earlier, _)| state < *earlier) {
                    *failure = Some((state, error));
                }
            }
        }
    }

    /// Waits for a while, awake. A thread of rayon's has other work to do.
    fn await_others(&self) {
        let is_alone = rayon::current_thread_index().is_none();
        for _ in 0..if is_alone { MOST_LOOKS } else { 0 } {
            if self.at_work.load(Ordering::Acquire) == 0 {
                return;
            }
            spin_loop();
        }
    }

    /// A share of the states that are left: large ones at first, for each costs a little, and small ones at last, so
    /// that all threads end together.
    fn next(&self) -> Option<Part<R, E, F, B, A, O, N>> {
        let mut rest = self.rest.lock().unwrap_or_else(PoisonError::into_inner);
        let fair = (rest.states / (2 * self.threads)).max(self.least);
        let share = fair.next_multiple_of(MOST_LANES).min(rest.states);
        (share > 0).then(|| rest.take(share))
    }
}
