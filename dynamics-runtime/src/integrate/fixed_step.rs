//! Integration by steps of equal length.

use super::{Failure, Grid, Phase, Stepper};

/// A method that knows nothing but the phase that a step starts from.
pub(crate) trait OneStep<S, E, const N: usize> {
    /// The phase after a step of length `h` from `phase` at `t`.
    fn step(
        &mut self,
        system: &S,
        t: f64,
        phase: &Phase<N>,
        h: f64,
    ) -> Result<Phase<N>, Failure<E>>;
}

/// An integration by steps of equal length.
pub(crate) struct FixedStep<M, const N: usize> {
    method: M,
    grid: Grid,
    taken: u64,
    t: f64,
    phase: Phase<N>,
}

impl<M, const N: usize> FixedStep<M, N> {
    /// At the start.
    pub(crate) fn start(method: M, grid: Grid, phase: Phase<N>) -> Self {
        FixedStep {
            method,
            grid,
            taken: 0,
            t: 0.0,
            phase,
        }
    }
}

impl<S, E, M: OneStep<S, E, N>, const N: usize> Stepper<S, E, N> for FixedStep<M, N> {
    fn t(&self) -> f64 {
        self.t
    }

    fn phase(&self) -> &Phase<N> {
        &self.phase
    }

    #[inline]
    fn step(&mut self, system: &S, _: f64) -> Result<(), Failure<E>> {
        let h = self.grid.step();
        self.phase = self.method.step(system, self.t, &self.phase, h)?;
        self.taken += 1;
        self.t = self.grid.time(self.taken);
        Ok(())
    }

    /// Samples are ends of steps.
    fn at(&mut self, _: &S, t: f64) -> Result<Phase<N>, Failure<E>> {
        debug_assert_eq!(t, self.t);
        Ok(self.phase)
    }

    fn rejected(&self) -> u64 {
        0
    }
}
