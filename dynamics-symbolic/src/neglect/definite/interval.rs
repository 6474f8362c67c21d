//! Numbers that are known to lie between two doubles.

use crate::exact::Rational;
use crate::neglect::reals::{SINE_ERROR, sin_cos};
use crate::robot::{Interpretation, Value};
use core::f64::consts::PI;
use core::ops::{Add, Mul, Neg, Sub};

/// All numbers from `low` to `high`. Every result is widened to the next doubles, so that it holds the
/// true one whatever was rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    /// A double, exactly.
    pub(super) fn exact(x: f64) -> Self {
        Interval { low: x, high: x }
    }

    /// A number that is within `error` of x.
    fn around(x: f64, error: f64) -> Self {
        Interval::rounded(x - error, x + error)
    }

    fn rounded(low: f64, high: f64) -> Self {
        Interval {
            low: low.next_down(),
            high: high.next_up(),
        }
    }

    /// Whether every number of it is positive; what is not a number is not.
    pub(super) fn is_positive(self) -> bool {
        self.low > 0.0 && self.high < f64::INFINITY
    }

    /// The quotient by an interval; everything where that holds zero.
    pub(super) fn over(self, divisor: Self) -> Self {
        if divisor.low <= 0.0 && divisor.high >= 0.0 {
            return Interval {
                low: f64::NEG_INFINITY,
                high: f64::INFINITY,
            };
        }
        let ends = |a: f64| [a / divisor.low, a / divisor.high];
        Interval::hull([ends(self.low), ends(self.high)].concat())
    }

    fn hull(ends: Vec<f64>) -> Self {
        // `f64::min` would lose what is not a number.
        let least = |a: f64, b: f64| if a.is_nan() || b > a { a } else { b };
        let low = ends.iter().copied().fold(f64::INFINITY, least);
        let high = -ends.iter().map(|x| -x).fold(f64::INFINITY, least);
        Interval::rounded(low, high)
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Interval::rounded(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Interval {
            low: -self.high,
            high: -self.low,
        }
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        // Zero stays zero, so that what is not there costs no width.
        let zero = Interval::exact(0.0);
        let is_finite = |x: Self| x.low.is_finite() && x.high.is_finite();
        if self == zero && is_finite(other) || other == zero && is_finite(self) {
            return zero;
        }
        let ends = |a: f64| [a * other.low, a * other.high];
        Interval::hull([ends(self.low), ends(self.high)].concat())
    }
}

/// Reads a table without symbolic parameters.
pub(super) struct Intervals;

impl Interpretation for Intervals {
    type Number = Interval;

    fn rational(&mut self, x: &Rational) -> Interval {
        let nearest = x.to_f64().value();
        match Rational::try_from(nearest) {
            Ok(exact) if exact == *x => Interval::exact(nearest),
            _ => Interval::rounded(nearest, nearest),
        }
    }

    fn pi(&mut self) -> Interval {
        Interval::rounded(PI, PI)
    }

    /// The macro asks for numbers before.
    fn field(&mut self, _: usize) -> Interval {
        Interval::exact(f64::NAN)
    }

    fn quotient(&mut self, a: Interval, b: Interval) -> Interval {
        a.over(b)
    }

    fn circle(&mut self, angle: &Value) -> (Interval, Interval) {
        let Interval { low, high } = self.value(angle);
        let middle = 0.5 * low + 0.5 * high;
        let (s, c) = sin_cos(middle);
        // The slope of both is at most 1; taking quarter turns off an angle is rounded.
        let error = SINE_ERROR * (1.0 + middle.abs()) + (high - low);
        (Interval::around(s, error), Interval::around(c, error))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn third() -> Interval {
        Intervals.rational(&(Rational::ONE / Rational::from(3)))
    }

    fn holds(interval: Interval, x: f64) -> bool {
        interval.low <= x && x <= interval.high
    }

    #[test]
    fn results_hold_the_true_number() {
        let one = Interval::exact(1.0);
        assert!(third().low < third().high);
        let three = third() + third() + third();
        assert!(holds(three, 1.0) && three.high - three.low < 1e-15);
        assert!(holds(one.over(third()), 3.0));
        assert!(holds((third() - one) * Interval::exact(-3.0), 2.0));
        assert!(holds(third() * -third(), -1.0 / 9.0));
    }

    #[test]
    fn positive_is_what_holds_no_other_number() {
        let one = Interval::exact(1.0);
        assert!(one.is_positive() && third().is_positive());
        assert!(!(third() + third() + third() - one).is_positive());
        assert!(!one.over(one - one).is_positive());
        assert!(!(one * Interval::exact(f64::NAN)).is_positive());
        assert!(!(one + Interval::exact(f64::NAN)).is_positive());
        assert!(!one.over(Interval::exact(f64::NAN)).is_positive());
    }

    #[test]
    fn sines_hold_the_true_number() {
        // sin(1/2)
        let half = Value::Rational(Rational::ONE / Rational::from(2));
        let (s, c) = Intervals.circle(&half);
        assert!(holds(s, 0.479425538604203) && holds(c, 0.8775825618903728));
        assert!(s.high - s.low < 2e-14);
    }
}
