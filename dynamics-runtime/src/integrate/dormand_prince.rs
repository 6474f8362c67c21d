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

/// The method RK5(4)7M of Dormand and Prince (1980).
pub(crate) struct DormandPrince54;

impl<const N: usize> Embedded<N> for DormandPrince54 {
    type Rates = [Phase<N>; STAGES];

    /// Of fourth degree (Hairer, Nørsett, Wanner I, section II.6, in the form of their program
    /// DOPRI5).
    type Polynomial = [Phase<N>; 5];

    const LAST: usize = STAGES - 1;

    /// Those of the program DOPRI5.
    const CONTROL: Constants = Constants {
        order: 5.0,
        beta: 0.04,
        factors: (0.2, 10.0),
    };

    fn rates(rate: Phase<N>) -> Self::Rates {
        [rate; STAGES]
    }

    #[inline]
    fn trial<S: Equations<N>>(
        system: &S,
        from: &Start<N>,
        rates: &mut Self::Rates,
    ) -> Result<Phase<N>, S::Refusal> {
        stage::<1, S, N>(system, from, rates)?;
        stage::<2, S, N>(system, from, rates)?;
        stage::<3, S, N>(system, from, rates)?;
        stage::<4, S, N>(system, from, rates)?;
        stage::<5, S, N>(system, from, rates)?;
        stage::<6, S, N>(system, from, rates)
    }

    #[inline]
    fn error(h: f64, rates: &Self::Rates, norm: impl Fn(&Phase<N>) -> f64) -> f64 {
        norm(&combination(&ERROR, rates).scaled(h))
    }

    fn polynomial<S: Equations<N>>(
        _: &S,
        from: &Start<N>,
        end: &Phase<N>,
        rates: &mut Self::Rates,
    ) -> Result<Self::Polynomial, S::Refusal> {
        let change = end.minus(&from.phase);
        let bend = rates[0].scaled(from.h).minus(&change);
        let twist = change.minus(&rates[STAGES - 1].scaled(from.h)).minus(&bend);
        let lift = combination(&DENSE, rates).scaled(from.h);
        Ok([from.phase, change, bend, twist, lift])
    }

    /// y = r1 + s (r2 + (1 - s) (r3 + s (r4 + (1 - s) r5))).
    fn evaluate([r1, r2, r3, r4, r5]: &Self::Polynomial, s: f64) -> Phase<N> {
        let inner = r3.plus(s, &r4.plus(1.0 - s, r5));
        r1.plus(s, &r2.plus(1.0 - s, &inner))
    }
}

/// Evaluates stage `I` from those before it, and returns its phase; with `I` a constant the sum is
/// unrolled.
#[inline(always)]
fn stage<const I: usize, S: Equations<N>, const N: usize>(
    system: &S,
    from: &Start<N>,
    rates: &mut [Phase<N>; STAGES],
) -> Result<Phase<N>, S::Refusal> {
    let phase = from.plus(&A[I][..I], rates);
    rates[I] = system.rate(from.t + C[I] * from.h, &phase)?;
    Ok(phase)
}
