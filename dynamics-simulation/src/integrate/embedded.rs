//! Explicit methods with error control and dense output.

use core::ops::{Index, IndexMut};

use dynamics_runtime::Size;

use super::step_control::Constants;
use super::{Equations, Phase, Start};

/// An explicit Runge-Kutta method with an error estimate and dense output.
pub(crate) trait Embedded<D: Size> {
    /// The rates of all stages, those of the dense output among them.
    type Rates: Clone + Index<usize, Output = Phase<D>> + IndexMut<usize>;

    /// Coefficients of the polynomial through a step.
    type Polynomial: Clone;

    /// The stage at the end of the step, which is the first of the next step.
    const LAST: usize;

    /// How the step size is chosen.
    const CONTROL: Constants;

    /// All stages at one rate.
    fn rates(rate: Phase<D>) -> Self::Rates;

    /// Evaluates the stages of a step but the first, and returns the end of the step.
    fn trial<S: Equations<D>>(
        system: &S,
        from: &Start<D>,
        rates: &mut Self::Rates,
    ) -> Result<Phase<D>, S::Refusal>;

    /// Evaluates the stage [`LAST`](Embedded::LAST), where the trial did not.
    fn finish<S: Equations<D>>(
        _system: &S,
        _from: &Start<D>,
        _end: &Phase<D>,
        _rates: &mut Self::Rates,
    ) -> Result<(), S::Refusal> {
        Ok(())
    }

    /// Size of the error of a step, 1 at the tolerance, where `norm` measures a phase.
    fn error(h: f64, rates: &Self::Rates, norm: impl Fn(&Phase<D>) -> f64) -> f64;

    /// The polynomial through a step to `end`; may evaluate stages of its own.
    fn polynomial<S: Equations<D>>(
        system: &S,
        from: &Start<D>,
        end: &Phase<D>,
        rates: &mut Self::Rates,
    ) -> Result<Self::Polynomial, S::Refusal>;

    /// The polynomial at `s`, which runs from 0 to 1 over the step.
    fn evaluate(polynomial: &Self::Polynomial, s: f64) -> Phase<D>;
}

impl<D: Size> Start<D> {
    /// The phase plus h times the stages' rates, each by its weight.
    #[inline(always)]
    pub(super) fn plus(&self, weights: &[f64], rates: &[Phase<D>]) -> Phase<D> {
        self.phase.plus(self.h, &combination(weights, rates))
    }

    /// Evaluates stage `i` from those before it, and returns its phase; with `i` a constant the sum is unrolled.
    #[inline(always)]
    pub(super) fn stage<S: Equations<D>>(
        &self,
        system: &S,
        (a, c): (&[f64], f64),
        rates: &mut [Phase<D>],
        i: usize,
    ) -> Result<Phase<D>, S::Refusal> {
        let phase = self.plus(&a[..i], rates);
        rates[i] = system.rate(self.t + c * self.h, &phase)?;
        Ok(phase)
    }

    /// The first coefficients of the polynomial through the step to `end`, those of third order, from the rates at both
    /// ends.
    pub(super) fn cubic(&self, end: &Phase<D>, rates: [&Phase<D>; 2]) -> [Phase<D>; 4] {
        let change = end.minus(&self.phase);
        let bend = rates[0].scaled(self.h).minus(&change);
        let twist = change.minus(&rates[1].scaled(self.h)).minus(&bend);
        [self.phase.clone(), change, bend, twist]
    }
}

/// Sum of the stages' rates, each by its weight.
#[inline(always)]
pub(super) fn combination<D: Size>(weights: &[f64], rates: &[Phase<D>]) -> Phase<D> {
    let mut sum = Phase::zeros(rates[0].size());
    for (i, weight) in weights.iter().enumerate() {
        // A product with 0 could not be left out otherwise: a rate might be infinite.
        if *weight != 0.0 {
            sum = sum.plus(*weight, &rates[i]);
        }
    }
    sum
}
