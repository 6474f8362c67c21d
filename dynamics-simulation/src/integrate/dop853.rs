//! The method of order 8(5,3) of Dormand and Prince.
//!
//! Own code for the reasons given at [`DormandPrince54`](super::DormandPrince54).

use dynamics_runtime::Size;

use super::dop853_tableau::{A, C, DENSE, ERROR_5, LAST, STAGES, THIRD};
use super::embedded::{Embedded, combination};
use super::step_control::Constants;
use super::{Equations, Phase, Start};

/// DOP853 of Hairer, Nørsett and Wanner I, section II.5.
pub(crate) struct Dop853Method;

impl<D: Size> Embedded<D> for Dop853Method {
    type Rates = [Phase<D>; STAGES];

    /// The polynomial of seventh degree (section II.6, in the form of the program DOP853).
    type Polynomial = [Phase<D>; 8];

    const LAST: usize = LAST;

    /// The constants of the program DOP853.
    const CONTROL: Constants = Constants {
        order: 8.0,
        beta: 0.0,
        factors: (0.333, 6.0),
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
        // Unrolled for each stage, a run of the two-link arm takes a third longer.
        for i in 1..LAST {
            from.stage(system, (A[i], C[i]), rates, i)?;
        }
        Ok(from.plus(A[LAST], rates))
    }

    fn finish<S: Equations<D>>(
        system: &S,
        from: &Start<D>,
        end: &Phase<D>,
        rates: &mut Self::Rates,
    ) -> Result<(), S::Refusal> {
        rates[LAST] = system.rate(from.t + from.h, end)?;
        Ok(())
    }

    /// h e5^2 / sqrt(e5^2 + 0.01 e3^2) with the errors e5 and e3 of the embedded results of order
    /// 5 and 3, so that the estimate falls with h^8 (section II.10, (10.17)).
    #[inline]
    fn error(h: f64, rates: &Self::Rates, norm: impl Fn(&Phase<D>) -> f64) -> f64 {
        let fifth = norm(&combination(&ERROR_5, rates)).powi(2);
        let third = norm(&third(rates)).powi(2);
        if fifth == 0.0 {
            return 0.0;
        }
        h.abs() * fifth / (fifth + 0.01 * third).sqrt()
    }

    fn polynomial<S: Equations<D>>(
        system: &S,
        from: &Start<D>,
        end: &Phase<D>,
        rates: &mut Self::Rates,
    ) -> Result<Self::Polynomial, S::Refusal> {
        for i in LAST + 1..STAGES {
            from.stage(system, (A[i], C[i]), rates, i)?;
        }
        let [r1, r2, r3, r4] = from.cubic(end, [&rates[0], &rates[LAST]]);
        let [r5, r6, r7, r8] = DENSE.map(|row| combination(&row, rates).scaled(from.h));
        Ok([r1, r2, r3, r4, r5, r6, r7, r8])
    }

    /// y = r1 + s (r2 + (1 - s) (r3 + s (r4 + (1 - s) (r5 + s (r6 + (1 - s) (r7 + s r8)))))).
    fn evaluate(r: &Self::Polynomial, s: f64) -> Phase<D> {
        let factors = [1.0 - s, s];
        (0..7).rev().fold(r[7].clone(), |inner, i| {
            r[i].plus(factors[(i + 1) % 2], &inner)
        })
    }
}

/// Result of order 8 minus that of order 3, without the factor h.
#[inline(always)]
fn third<D: Size>(rates: &[Phase<D>; STAGES]) -> Phase<D> {
    let subtract = |sum: Phase<D>, (i, weight): &(usize, f64)| sum.plus(-weight, &rates[*i]);
    let eighth = combination(A[LAST], rates);
    THIRD.iter().fold(eighth, subtract)
}
