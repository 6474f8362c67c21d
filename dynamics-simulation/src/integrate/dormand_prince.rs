//! The Dormand-Prince method of order 5(4).
//!
//! Own code because no crate fits: `ode_solvers` 0.6.2 builds on another nalgebra, and the right-hand side of
//! `differential-equations` 0.7.0 cannot fail. That crate also brings nalgebra's default features into every build.

use dynamics_runtime::Size;

use super::dormand_prince_tableau::{A, C, DENSE, ERROR, STAGES};
use super::embedded::{Embedded, combination};
use super::step_control::Constants;
use super::{Equations, Phase, Start};

/// The method RK5(4)7M of Dormand and Prince (1980).
pub(crate) struct DormandPrince54;

impl<D: Size> Embedded<D> for DormandPrince54 {
    type Rates = [Phase<D>; STAGES];

    /// The polynomial of fourth degree (Hairer, Nørsett, Wanner I, section II.6, in the form of their program DOPRI5).
    type Polynomial = [Phase<D>; 5];

    const LAST: usize = STAGES - 1;

    /// The constants of the program DOPRI5.
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
        from.stage(system, (&A[1], C[1]), rates, 1)?;
        from.stage(system, (&A[2], C[2]), rates, 2)?;
        from.stage(system, (&A[3], C[3]), rates, 3)?;
        from.stage(system, (&A[4], C[4]), rates, 4)?;
        from.stage(system, (&A[5], C[5]), rates, 5)?;
        from.stage(system, (&A[6], C[6]), rates, 6)
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
        let [r1, r2, r3, r4] = from.cubic(end, [&rates[0], &rates[STAGES - 1]]);
        let r5 = combination(&DENSE, rates).scaled(from.h);
        Ok([r1, r2, r3, r4, r5])
    }

    /// y = r1 + s (r2 + (1 - s) (r3 + s (r4 + (1 - s) r5))).
    fn evaluate([r1, r2, r3, r4, r5]: &Self::Polynomial, s: f64) -> Phase<D> {
        let inner = r3.plus(s, &r4.plus(1.0 - s, r5));
        r1.plus(s, &r2.plus(1.0 - s, &inner))
    }
}
