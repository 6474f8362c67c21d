//! Numbers with a bound on their error, and the rule of each operation.
//!
//! A processor computes `a + b` as the sum of the operands that it has, times `1 + d` with |d| <= u. The result is
//! therefore wrong by the errors of the operands, passed on by the operation, and by u times its own size at most
//! (Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 3.3).
//!
//! These rules are for doubles at one point. The roundings of the bound itself, about 1e-16 of it, are left out. They
//! are counted in the two other statements of the rules: `ranged`, over a box of points, and
//! [`Real`](crate::program::Real), in high precision.

use crate::operators::impl_operators;

/// u, the largest relative error of one operation.
pub const UNIT: f64 = f64::EPSILON / 2.0;

/// A number as it is computed, and a bound of its distance from the exact one: infinite where nothing is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// The number that is computed.
    pub value: f64,
    /// How far from the exact number that may be.
    pub error: f64,
}

impl Bounded {
    /// A number that is what it stands for: an input, a sign.
    pub fn exact(value: f64) -> Self {
        Bounded { value, error: 0.0 }
    }

    /// A number that was rounded once: a constant, a sine.
    pub fn rounded(value: f64) -> Self {
        let error = UNIT * value.abs();
        Bounded { value, error }
    }

    /// A constant: those with a mantissa of 1, which every format has, are not rounded.
    pub fn constant(value: f64) -> Self {
        const MANTISSA: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
        let is_exact = value.to_bits() & MANTISSA == 0;
        let error = if is_exact { 0.0 } else { UNIT * value.abs() };
        Bounded { value, error }
    }

    /// A result that is rounded once, from operands that contribute `error`.
    fn from_operands(value: f64, error: f64) -> Self {
        let error = error + UNIT * value.abs();
        let is_known = value.is_finite() && !error.is_nan();
        Bounded {
            value,
            error: if is_known { error } else { f64::INFINITY },
        }
    }
}

impl_operators! {
    impl [] for Bounded;
    Neg neg |a| Bounded { value: -a.value, ..a };
    /// |(a + b) - (a' + b')| <= e_a + e_b
    Add add |a, b| Bounded::from_operands(a.value + b.value, a.error + b.error);
    /// |a b - a' b'| <= |a| e_b + |b| e_a + e_a e_b
    Mul mul |a, b| {
        let linear = a.value.abs() * b.error + b.value.abs() * a.error;
        Bounded::from_operands(a.value * b.value, linear + a.error * b.error)
    };
    /// |a/b - a'/b'| <= (e_a + |a/b| e_b) / (|b| - e_b)
    Div div |a, b| {
        let quotient = a.value / b.value;
        let room = b.value.abs() - b.error;
        let error = if room > 0.0 {
            (a.error + quotient.abs() * b.error) / room
        } else {
            f64::INFINITY
        };
        Bounded::from_operands(quotient, error)
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Rational, SplitMix64};

    /// The exact number that a double is.
    fn rational(x: f64) -> Rational {
        Rational::try_from(x).expect("finite")
    }

    fn holds(computed: Bounded, exact: &Rational) -> bool {
        let difference = rational(computed.value) - exact;
        // The bound's own roundings are left out: a millionth for them.
        let bound = rational(computed.error * (1.0 + 1e-6) + f64::MIN_POSITIVE);
        -&bound <= difference && difference <= bound
    }

    /// Random expressions of four numbers, with the exact value beside the computed one: 3,000
    /// operations, cancellations among them.
    #[test]
    fn the_exact_result_is_within_the_bound() {
        let mut random = SplitMix64::new(1);
        for _ in 0..500 {
            let mut pick = |n: u64| (random.next_u64() % n) as usize;
            let inputs = [(); 4].map(|()| (pick(2001) as f64 - 1000.5) * 0.001);
            let mut numbers: Vec<_> = inputs.map(|x| (Bounded::constant(x), rational(x))).to_vec();
            for _ in 0..6 {
                let (a, x) = numbers[pick(numbers.len() as u64)].clone();
                let (b, y) = numbers[pick(numbers.len() as u64)].clone();
                let (computed, exact) = match pick(4) {
                    0 => (a + b, x + y),
                    1 => (a + -b, x - y),
                    3 if y != Rational::ZERO => (a / b, x / y),
                    _ => (a * b, x * y),
                };
                assert!(holds(computed, &exact), "{computed:?}");
                numbers.push((computed, exact));
            }
        }
    }

    #[test]
    fn cancellation_keeps_the_error_of_what_cancels() {
        let (a, b) = (Bounded::rounded(1e6 + 0.5), Bounded::rounded(-1e6));
        let difference = a + b;
        assert_eq!(difference.value, 0.5);
        assert!(difference.error > 1e6 * UNIT && difference.error < 4e6 * UNIT);
    }

    #[test]
    fn nothing_is_known_of_a_quotient_by_what_may_be_zero() {
        let divisor = Bounded {
            value: 1e-17,
            error: 1e-16,
        };
        assert_eq!((Bounded::exact(1.0) / divisor).error, f64::INFINITY);
        let zero = Bounded::exact(0.0);
        assert_eq!((zero / zero).error, f64::INFINITY);
        assert_eq!((zero / zero + zero).error, f64::INFINITY);
    }

    #[test]
    fn powers_of_two_are_not_rounded() {
        assert_eq!(Bounded::constant(-0.25).error, 0.0);
        assert_eq!(Bounded::constant(0.3).error, 0.3 * UNIT);
    }
}
