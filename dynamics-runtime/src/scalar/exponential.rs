//! The exponential function in any arithmetic.
//!
//! `f64` and `f32` have those of the crate `libm` (after FreeBSD's `e_exp.c` and `e_expf.c`) on every platform: less than
//! one unit in the last place off, each in its own precision.

use crate::Scalar;

/// log 2 in parts: the first with 21 bits to spare, for exact multiples, the others the double nearest to the rest.
const LOG_2: [f64; 4] = [
    0.693_147_180_369_123_8,
    1.908_214_929_270_587_7e-10,
    1.161_222_722_936_253_2e-26,
    -5.711_779_795_757_43e-43,
];

/// Halvings of the argument that is left, and terms of its series: 0.35 / 2^8 to the 13th power over 13! is 3e-48.
const HALVINGS: u32 = 8;
const TERMS: u32 = 12;

/// e^x to about ten roundings: x = n log 2 + r, and e^r - 1 by a series in r / 2^8, of which
/// (1 + y)^2 - 1 = y (2 + y) makes that of r, with an error that doubles with y itself.
pub(crate) fn by_reduction<T: Scalar>(x: T) -> T {
    let one = x.constant(1.0);
    let size = x.ratio_to_f64(one);
    if size < -750.0 {
        return x.constant(0.0);
    }
    if size > 750.0 {
        return x.constant(f64::INFINITY);
    }
    let n = libm::rint(size * core::f64::consts::LOG2_E);
    let r = LOG_2
        .iter()
        .fold(x, |rest, part| rest - x.constant(n) * x.constant(*part));
    let small = r * x.constant(1.0 / f64::from(1_u32 << HALVINGS));
    let series = (1..=TERMS).rev().fold(x.constant(0.0), |sum, k| {
        (one + sum) * small / x.constant(f64::from(k))
    });
    let less_one = (0..HALVINGS).fold(series, |y, _| y * (y + x.constant(2.0)));
    // In two steps, for 2^n may be no double where e^x is one.
    let half = libm::rint(n / 2.0);
    let [first, second] = [half, n - half].map(|n| x.constant(libm::scalbn(1.0, n as i32)));
    (one + less_one) * first * second
}

#[cfg(test)]
mod tests {
    use core::f64::consts::E;

    use super::by_reduction;
    use crate::dual::Dual;
    use crate::random::SplitMix64;
    use crate::{DoubleDouble, Scalar};

    /// x, and both halves of e^x, from a computation in 60 digits.
    const VALUES: [(f64, f64, f64); 5] = [
        (1.0, E, 1.4456468917292502e-16),
        (-0.5, 0.6065306597126334, -6.593178415491414e-19),
        (-10.0, 4.5399929762484854e-05, -2.637554055327531e-21),
        (-0.001, 0.999000499833375, -3.026024053145243e-17),
        (100.0, 2.6881171418161356e43, -1.6101271449201627e27),
    ];

    #[test]
    fn values_in_31_digits() {
        for (x, high, low) in VALUES {
            let value = Scalar::exp(DoubleDouble::from(x));
            let error = (value.high() - high) + (value.low() - low);
            assert!(error.abs() <= 5e-31 * high, "{x}: {error:e}");
        }
    }

    /// The largest errors in units of the last place, where this was written: 0.84, and 2.1 by reduction.
    #[test]
    fn errors_of_doubles_are_below_one_unit() {
        let mut random = SplitMix64(1);
        let (mut worst, mut single, mut plain): (f64, f64, f64) = (0.0, 0.0, 0.0);
        for range in [-700.0..=700.0, -40.0..=0.0, -1.0..=1.0, -1e-3..=1e-3] {
            for _ in 0..50_000 {
                let x = random.within(&range);
                let exact = Scalar::exp(DoubleDouble::from(x));
                let unit = f64::from_bits(exact.high().to_bits() + 1) - exact.high();
                let error = |found: f64| ((found - exact.high()) - exact.low()).abs() / unit;
                worst = worst.max(error(Scalar::exp(x)));
                plain = plain.max(error(by_reduction(x)));
                single = single.max(error_of_single(x as f32));
            }
        }
        println!(
            "f64 {worst:.3}, f32 {single:.3}, by reduction {plain:.3} units in the last place"
        );
        assert!(worst < 1.0 && single < 1.0, "{worst} {single}");
        assert!(plain < 40.0, "{plain}");
    }

    /// In units of the last place of single precision, where e^x is a normal number of it.
    fn error_of_single(x: f32) -> f64 {
        let (found, exact) = (Scalar::exp(x), Scalar::exp(f64::from(x)));
        let size = exact as f32;
        if !(f32::MIN_POSITIVE..f32::MAX).contains(&size) {
            return 0.0;
        }
        (f64::from(found) - exact).abs() / f64::from(size.next_up() - size)
    }

    #[test]
    fn the_ends() {
        for exp in [Scalar::exp, by_reduction::<f64>] {
            assert_eq!(exp(0.0), 1.0);
            assert_eq!(exp(f64::NEG_INFINITY), 0.0);
            assert_eq!(exp(-1e300), 0.0);
            assert_eq!(exp(f64::INFINITY), f64::INFINITY);
            assert!(exp(f64::NAN).is_nan());
            let subnormal = exp(-740.0);
            assert!(subnormal > 0.0 && subnormal < f64::MIN_POSITIVE);
        }
    }

    #[test]
    fn the_derivative_is_the_value() {
        let x = Dual::new(-1.3, 2.0);
        let value = Scalar::exp(-1.3_f64);
        assert_eq!(x.exp(), Dual::new(value, 2.0 * value));
        let reduced = by_reduction(x);
        assert!((reduced.slope - 2.0 * reduced.value).abs() < 1e-14);
    }
}
