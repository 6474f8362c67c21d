//! Integration by steps of equal length.

use dynamics_runtime::Size;

use super::{Failure, Grid, Phase, Start, Stepper};

/// A method that needs nothing but the phase that a step starts from.
pub(crate) trait OneStep<S, E, D: Size> {
    /// The phase after a step.
    fn step(&mut self, system: &S, from: &Start<D>) -> Result<Phase<D>, Failure<E>>;

    /// The next step is under other equations: what one step hands on to the next is void.
    fn restart(&mut self) {}

    /// As [`Equations::recentred`](super::Equations::recentred).
    fn recentred(&self, _system: &S, _phase: &Phase<D>) -> Option<D::Vector> {
        None
    }
}

/// An integration by steps of equal length.
pub(crate) struct FixedStep<M, D: Size> {
    method: M,
    grid: Grid,
    /// Steps of the grid that have ended.
    taken: u64,
    next: Start<D>,
    last: Start<D>,
}

impl<M, D: Size> FixedStep<M, D> {
    /// At the start.
    pub(crate) fn start(method: M, grid: Grid, phase: Phase<D>) -> Self {
        let (t, h) = (0.0, grid.step());
        let next = Start { t, phase, h };
        FixedStep {
            method,
            grid,
            taken: 0,
            last: next.clone(),
            next,
        }
    }
}

/// Whether two times differ by no more than the rounding of both.
fn same(t: f64, other: f64) -> bool {
    (t - other).abs() <= 4.0 * f64::EPSILON * other.abs()
}

impl<S, E, M: OneStep<S, E, D>, D: Size> Stepper<S, E, D> for FixedStep<M, D> {
    fn t(&self) -> f64 {
        self.next.t
    }

    fn phase(&self) -> &Phase<D> {
        &self.next.phase
    }

    #[inline]
    fn step(&mut self, system: &S, end: f64) -> Result<(), Failure<E>> {
        let next = self.grid.time(self.taken + 1);
        let is_end_next = same(end, next);
        // An end that is the next point of the grid except for rounding is that point.
        let t = if end < next || is_end_next { end } else { next };
        // From within the grid, after an event, to its next point.
        let h = if t == next && self.next.t == self.grid.time(self.taken) {
            self.grid.step()
        } else {
            t - self.next.t
        };
        self.next.h = h;
        let phase = self.method.step(system, &self.next)?;
        self.last = core::mem::replace(&mut self.next, Start { t, phase, h });
        self.taken += u64::from(is_end_next || next < end);
        Ok(())
    }

    fn retake(&mut self, system: &S, end: f64) -> Result<(), Failure<E>> {
        self.last.h = end - self.last.t;
        self.next.phase = self.method.step(system, &self.last)?;
        let beyond = |point: f64| point > end && !same(point, end);
        while self.taken > 0 && beyond(self.grid.time(self.taken)) {
            self.taken -= 1;
        }
        self.next.t = end;
        Ok(())
    }

    fn restart(&mut self, _: &S, phase: Phase<D>) -> Result<(), Failure<E>> {
        self.method.restart();
        self.next.phase = phase;
        Ok(())
    }

    fn recentre(&mut self, system: &S) {
        if let Some(q) = self.method.recentred(system, &self.next.phase) {
            self.next.phase.q = q;
        }
    }

    /// Samples are ends of steps.
    fn at(&mut self, _: &S, t: f64) -> Result<Phase<D>, Failure<E>> {
        debug_assert!(same(t, self.next.t), "{t} {}", self.next.t);
        Ok(self.next.phase.clone())
    }
}
