//! Explicit methods with error control and dense output.

use core::ops::{Index, IndexMut};

use super::step_control::Constants;
use super::{Equations, Phase, Start};

/// An explicit Runge-Kutta method with an error estimate and dense output.
pub(crate) trait Embedded<const N: usize> {
    /// The rates of all stages, those of the dense output among them.
    type Rates: Copy + Index<usize, Output = Phase<N>> + IndexMut<usize>;

    /// Coefficients of the polynomial through a step.
    type Polynomial: Copy;

    /// The stage at the end of the step, which is the first of the next step.
    const LAST: usize;

    /// How the step size is chosen.
    const CONTROL: Constants;

    /// All stages at one rate.
    fn rates(rate: Phase<N>) -> Self::Rates;

    /// Evaluates the stages of a step but the first, and returns the end of the step.
    fn trial<S: Equations<N>>(
        system: &S,
        from: &Start<N>,
        rates: &mut Self::Rates,
    ) -> Result<Phase<N>, S::Refusal>;

    /// Evaluates the stage [`LAST`](Embedded::LAST), where the trial did not.
    fn finish<S: Equations<N>>(
        _system: &S,
        _from: &Start<N>,
        _end: &Phase<N>,
        _rates: &mut Self::Rates,
    ) -> Result<(), S::Refusal> {
        Ok(())
    }

    /// Size of the error of a step, 1 at the tolerance, where `norm` measures a phase.
    fn error(h: f64, rates: &Self::Rates, norm: impl Fn(&Phase<N>) -> f64) -> f64;

    /// The polynomial through a step to `end`; may evaluate stages of its own.
    fn polynomial<S: Equations<N>>(
        system: &S,
        from: &Start<N>,
        end: &Phase<N>,
        rates: &mut Self::Rates,
    ) -> Result<Self::Polynomial, S::Refusal>;

    /// The polynomial at `s`, which runs from 0 to 1 over the step.
    fn evaluate(polynomial: &Self::Polynomial, s: f64) -> Phase<N>;
}

impl<const N: usize> Start<N> {
    /// The phase plus h times the stages' rates, each by its weight.
    #[inline(always)]
    pub(super) fn plus<const STAGES: usize>(
        &self,
        weights: &[f64],
        rates: &[Phase<N>; STAGES],
    ) -> Phase<N> {
        self.phase.plus(self.h, &combination(weights, rates))
    }

    /// Evaluates stage `i` from those before it, and returns its phase; with `i` a constant the sum is unrolled.
    #[inline(always)]
    pub(super) fn stage<S: Equations<N>, const STAGES: usize>(
        &self,
        system: &S,
        (a, c): (&[f64], f64),
        rates: &mut [Phase<N>; STAGES],
        i: usize,
    ) -> Result<Phase<N>, S::Refusal> {
        let phase = self.plus(&a[..i], rates);
        rates[i] = system.rate(self.t + c * self.h, &phase)?;
        Ok(phase)
    }

    /// The first coefficients of the polynomial through the step to `end`, those of third order, from the rates at both
    /// ends.
    pub(super) fn cubic(&self, end: &Phase<N>, rates: [&Phase<N>; 2]) -> [Phase<N>; 4] {
        let change = end.minus(&self.phase);
        let bend = rates[0].scaled(self.h).minus(&change);
        let twist = change.minus(&rates[1].scaled(self.h)).minus(&bend);
        [self.phase, change, bend, twist]
    }
}

/// Sum of the stages' rates, each by its weight.
#[inline(always)]
pub(super) fn combination<const STAGES: usize, const N: usize>(
    weights: &[f64],
    rates: &[Phase<N>; STAGES],
) -> Phase<N> {
    let mut sum = Phase::zeros();
    for (i, weight) in weights.iter().enumerate() {
        // A product with 0 could not be left out otherwise: a rate might be infinite.
        if *weight != 0.0 {
            sum = sum.plus(*weight, &rates[i]);
        }
    }
    sum
}
