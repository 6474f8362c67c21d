//! Integration by steps of equal length.

use super::{Failure, Grid, Phase, Start, Stepper};

/// A method that needs nothing but the phase that a step starts from.
pub(crate) trait OneStep<S, E, const N: usize> {
    /// The phase after a step.
    fn step(&mut self, system: &S, from: &Start<N>) -> Result<Phase<N>, Failure<E>>;

    /// The next step is under other equations: what one step hands on to the next is void.
    fn restart(&mut self) {}
}

/// An integration by steps of equal length.
pub(crate) struct FixedStep<M, const N: usize> {
    method: M,
    grid: Grid,
    /// Steps of the grid that have ended.
    taken: u64,
    t: f64,
    phase: Phase<N>,
    /// The last step.
    last: Start<N>,
}

impl<M, const N: usize> FixedStep<M, N> {
    /// At the start.
    pub(crate) fn start(method: M, grid: Grid, phase: Phase<N>) -> Self {
        let (t, h) = (0.0, 0.0);
        FixedStep {
            method,
            grid,
            taken: 0,
            t,
            phase,
            last: Start { t, phase, h },
        }
    }
}

/// Whether two times differ by no more than the rounding of both.
fn same(t: f64, other: f64) -> bool {
    (t - other).abs() <= 4.0 * f64::EPSILON * other.abs()
}

impl<S, E, M: OneStep<S, E, N>, const N: usize> Stepper<S, E, N> for FixedStep<M, N> {
    fn t(&self) -> f64 {
        self.t
    }

    fn phase(&self) -> &Phase<N> {
        &self.phase
    }

    #[inline]
    fn step(&mut self, system: &S, end: f64) -> Result<(), Failure<E>> {
        let next = self.grid.time(self.taken + 1);
        let is_end_next = same(end, next);
        // An end that is the next point of the grid but for rounding is that point.
        let to = if end < next || is_end_next { end } else { next };
        // From within the grid, after an event, to its next point.
        let h = if to == next && self.t == self.grid.time(self.taken) {
            self.grid.step()
        } else {
            to - self.t
        };
        let (t, phase) = (self.t, self.phase);
        let from = Start { t, phase, h };
        self.phase = self.method.step(system, &from)?;
        self.last = from;
        self.taken += u64::from(is_end_next || next < end);
        self.t = to;
        Ok(())
    }

    fn retake(&mut self, system: &S, end: f64) -> Result<(), Failure<E>> {
        let h = end - self.last.t;
        self.phase = self.method.step(system, &Start { h, ..self.last })?;
        let beyond = |point: f64| point > end && !same(point, end);
        while self.taken > 0 && beyond(self.grid.time(self.taken)) {
            self.taken -= 1;
        }
        self.t = end;
        Ok(())
    }

    fn restart(&mut self, _: &S, phase: Phase<N>) -> Result<(), Failure<E>> {
        self.method.restart();
        self.phase = phase;
        Ok(())
    }

    /// Samples are ends of steps.
    fn at(&mut self, _: &S, t: f64) -> Result<Phase<N>, Failure<E>> {
        debug_assert!(same(t, self.t), "{t} {}", self.t);
        Ok(self.phase)
    }

    fn rejected(&self) -> u64 {
        0
    }
}
