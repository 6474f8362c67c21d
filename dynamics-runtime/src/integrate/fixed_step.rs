//! Integration by steps of equal length.

use super::{Failure, Grid, Phase, Stepper};
use crate::size::Size;

/// A method that needs nothing but the phase that a step starts from.
pub(crate) trait OneStep<S, E, D: Size> {
    /// The phase after a step of length `h` from `phase` at `t`.
    fn step(
        &mut self,
        system: &S,
        t: f64,
        phase: &Phase<D>,
        h: f64,
    ) -> Result<Phase<D>, Failure<E>>;

    /// The next step is under other equations: what one step hands on to the next is void.
    fn restart(&mut self) {}
}

/// An integration by steps of equal length.
pub(crate) struct FixedStep<M, D: Size> {
    method: M,
    grid: Grid,
    /// Steps of the grid that have ended.
    taken: u64,
    t: f64,
    phase: Phase<D>,
    /// Where the last step started.
    from: (f64, Phase<D>),
}

impl<M, D: Size> FixedStep<M, D> {
    /// At the start.
    pub(crate) fn start(method: M, grid: Grid, phase: Phase<D>) -> Self {
        FixedStep {
            method,
            grid,
            taken: 0,
            t: 0.0,
            from: (0.0, phase.clone()),
            phase,
        }
    }
}

/// Whether two times differ by no more than the rounding of both.
fn same(t: f64, other: f64) -> bool {
    (t - other).abs() <= 4.0 * f64::EPSILON * other.abs()
}

impl<S, E, M: OneStep<S, E, D>, D: Size> Stepper<S, E, D> for FixedStep<M, D> {
    fn t(&self) -> f64 {
        self.t
    }

    fn phase(&self) -> &Phase<D> {
        &self.phase
    }

    #[inline]
    fn step(&mut self, system: &S, end: f64) -> Result<(), Failure<E>> {
        let next = self.grid.time(self.taken + 1);
        let whole = same(end, next) || next < end;
        // An end that is the next point of the grid but for rounding is that point.
        let to = if end < next || same(end, next) {
            end
        } else {
            next
        };
        // From within the grid, after an event, to its next point.
        let h = if to == next && self.t == self.grid.time(self.taken) {
            self.grid.step()
        } else {
            to - self.t
        };
        let phase = self.method.step(system, self.t, &self.phase, h)?;
        self.from = (self.t, core::mem::replace(&mut self.phase, phase));
        self.taken += u64::from(whole);
        self.t = to;
        Ok(())
    }

    fn retake(&mut self, system: &S, end: f64) -> Result<(), Failure<E>> {
        let (t, phase) = &self.from;
        self.phase = self.method.step(system, *t, phase, end - t)?;
        let beyond = |point: f64| point > end && !same(point, end);
        while self.taken > 0 && beyond(self.grid.time(self.taken)) {
            self.taken -= 1;
        }
        self.t = end;
        Ok(())
    }

    fn restart(&mut self, _: &S, phase: Phase<D>) -> Result<(), Failure<E>> {
        self.method.restart();
        self.phase = phase;
        Ok(())
    }

    /// Samples are ends of steps.
    fn at(&mut self, _: &S, t: f64) -> Result<Phase<D>, Failure<E>> {
        debug_assert!(same(t, self.t), "{t} {}", self.t);
        Ok(self.phase.clone())
    }

    fn rejected(&self) -> u64 {
        0
    }
}
