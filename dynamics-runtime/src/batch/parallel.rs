//! The states of a batch over all cores.

use core::hint::spin_loop;
use core::marker::PhantomData;
use core::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use fearless_simd::Level;
use rayon::Scope;

use super::arguments::Arguments;
use super::arms::Arms;
use super::layout::{MOST_LANES, Sink};
use super::run::{Failure, Task};
use super::wide::Precision;
use crate::function::Function;

/// So many operations are done by one core at a time: some five microseconds of work, many times what it takes to
/// fetch them.
const LEAST_WORK: usize = 40_000;

/// So often a thread that has no work left looks whether the others are done, before it sleeps: some ten microseconds,
/// in which they evaluate what they have, and less than it takes to wake up.
const MOST_LOOKS: usize = 1_000;

impl<R, E, F, B, A, O, const N: usize> Task<R, E, F, B, A, O, N>
where
    R: Function<F, N>,
    E: Precision,
    F: Copy + Send,
    B: Arms<R> + Send,
    A: Arguments<R::Arguments, E>,
    O: Sink<R::Values, E>,
{
    /// The function at every state, on this core and on all that are free.
    pub(super) fn on_all_cores(mut self, level: Level) -> Failure {
        let least = (LEAST_WORK / (R::WORK as usize).max(1)).max(MOST_LANES);
        let threads = rayon::current_num_threads().min(self.states / (2 * least));
        if threads < 2 {
            return self.run(level);
        }
        let shared = Shared {
            rest: Mutex::new((0, self)),
            failure: Mutex::new(None),
            least,
            threads,
            at_work: AtomicUsize::new(threads - 1),
        };
        // Not `join`, which hands all of the work to other threads where this one is none of rayon's: this one
        // begins at once, while others wake up.
        rayon::in_place_scope(|scope| {
            shared.work(scope, threads - 1, level);
            shared.await_others();
        });
        let failure = shared.failure.into_inner();
        failure.unwrap_or_else(PoisonError::into_inner)
    }

    /// The first states, which are a task of their own.
    fn take(&mut self, states: usize) -> Self {
        let (arguments, other_arguments) = self.arguments.split(states);
        let (arms, other_arms) = self.arms.split(states);
        self.arguments = other_arguments;
        self.arms = other_arms;
        self.states -= states;
        Task {
            kind: PhantomData,
            function: self.function,
            arms,
            arguments,
            results: self.results.take(states),
            states,
        }
    }
}

/// A part of the states, and the number of its first one.
type Numbered<R, E, F, B, A, O, const N: usize> = (usize, Task<R, E, F, B, A, O, N>);

/// States that several threads evaluate, each of which takes some whenever it has none.
struct Shared<R, E, F, B, A, O, const N: usize> {
    /// What nobody has taken yet.
    rest: Mutex<Numbered<R, E, F, B, A, O, N>>,
    failure: Mutex<Failure>,
    /// So many states at a time, at least.
    least: usize,
    threads: usize,
    /// How many of the others have not come to the end.
    at_work: AtomicUsize,
}

impl<R, E, F, B, A, O, const N: usize> Shared<R, E, F, B, A, O, N>
where
    R: Function<F, N>,
    E: Precision,
    F: Copy + Send,
    B: Arms<R> + Send,
    A: Arguments<R::Arguments, E>,
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
        while let Some((first, mut task)) = self.next() {
            if let Some((state, error)) = task.run(level) {
                let mut failure = self.failure.lock().unwrap_or_else(PoisonError::into_inner);
                if failure
                    .as_ref()
                    .is_none_or(|(earlier, _)| first + state < *earlier)
                {
                    *failure = Some((first + state, error));
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
    fn next(&self) -> Option<Numbered<R, E, F, B, A, O, N>> {
        let mut rest = self.rest.lock().unwrap_or_else(PoisonError::into_inner);
        let (first, task) = &mut *rest;
        let share = (task.states / (2 * self.threads)).max(self.least);
        let share = share.next_multiple_of(MOST_LANES).min(task.states);
        let taken = (share > 0).then(|| (*first, task.take(share)));
        *first += share;
        taken
    }
}
