//! The Dormand-Prince method of order 5(4).
//!
//! Own code because no crate fits. `ode_solvers` 0.6.2 builds on another nalgebra.
//! `differential-equations` 0.7.0 was tried: its right-hand side cannot fail. Standing in for a
//! failure, a NaN at t = 1 of a pendulum cost 65,000 evaluations up to the limit of steps, and the
//! error that came then holds none of the samples before. It also brings nalgebra's default
//! features, two versions of syn among them, into every user's build.

use super::dormand_prince_tableau::{A, C, DENSE, ERROR, STAGES};
use super::embedded::{Embedded, Start, combination};
use super::step_control::Constants;
use super::{Equations, Phase};
use crate::size::Size;

/// The method RK5(4)7M of Dormand and Prince (1980).
pub(crate) struct DormandPrince54;

impl<D: Size> Embedded<D> for DormandPrince54 {
    type Rates = [Phase<D>; STAGES];

    /// Of fourth degree (Hairer, Nørsett, Wanner I, section II.6, in the form of their program
    /// DOPRI5).
    type Polynomial = [Phase<D>; 5];

    const LAST: usize = STAGES - 1;

    /// Those of the program DOPRI5.
    const CONTROL: Constants = Constants {
        order: 5.0,
        beta: 0.04,
        factors: (0.2, 10.0),
    };

    fn rates(rate: Phase<D>) -> Self::Rates {
        core::array::from_fn(|_| rate.clone())
    }

    #[inline]
    fn trial<S: Equations<D>>(
        system: &S,
        from: &Start<D>,
        rates: &mut Self::Rates,
    ) -> Result<Phase<D>, S::Refusal> {
        stage::<1, S, D>(system, from, rates)?;
        stage::<2, S, D>(system, from, rates)?;
        stage::<3, S, D>(system, from, rates)?;
        stage::<4, S, D>(system, from, rates)?;
        stage::<5, S, D>(system, from, rates)?;
        stage::<6, S, D>(system, from, rates)
    }

    #[inline]
    fn error(h: f64, rates: &Self::Rates, norm: impl Fn(&Phase<D>) -> f64) -> f64 {
        norm(&combination(&ERROR, rates).scaled(h))
    }

    fn polynomial<S: Equations<D>>(
        _: &S,
        from: &Start<D>,
        end: &Phase<D>,
        rates: &mut Self::Rates,
    ) -> Result<Self::Polynomial, S::Refusal> {
        let change = end.minus(&from.phase);
        let bend = rates[0].scaled(from.h).minus(&change);
        let twist = change.minus(&rates[STAGES - 1].scaled(from.h)).minus(&bend);
        let lift = combination(&DENSE, rates).scaled(from.h);
        Ok([from.phase.clone(), change, bend, twist, lift])
    }

    /// y = r1 + s (r2 + (1 - s) (r3 + s (r4 + (1 - s) r5))).
    fn evaluate([r1, r2, r3, r4, r5]: &Self::Polynomial, s: f64) -> Phase<D> {
        let inner = r3.plus(s, &r4.plus(1.0 - s, r5));
        r1.plus(s, &r2.plus(1.0 - s, &inner))
    }
}

/// Evaluates stage `I` from those before it, and returns its phase; with `I` a constant the sum is
/// unrolled.
#[inline(always)]
fn stage<const I: usize, S: Equations<D>, D: Size>(
    system: &S,
    from: &Start<D>,
    rates: &mut [Phase<D>; STAGES],
) -> Result<Phase<D>, S::Refusal> {
    let phase = from.plus(&A[I][..I], rates);
    rates[I] = system.rate(from.t + C[I] * from.h, &phase)?;
    Ok(phase)
}
