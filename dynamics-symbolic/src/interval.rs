//! Numbers that are known to lie between two doubles.

use crate::exact::{Rational, SINE_ERROR, sin_cos};
use crate::operators::impl_operators;
use crate::robot::{Interpretation, Value};
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// All numbers from `low` to `high`. Every result is widened to the next doubles, so that it holds the
/// true one whatever was rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    /// A double, exactly.
    pub(crate) fn exact(x: f64) -> Self {
        Interval { low: x, high: x }
    }

    /// All numbers from `low` to `high`.
    pub(crate) fn new(low: f64, high: f64) -> Self {
        Interval { low, high }
    }

    /// All numbers whose absolute value is at most `size`.
    pub(crate) fn symmetric(size: f64) -> Self {
        Interval::new(-size, size)
    }

    /// A number that is within `error` of x.
    fn around(x: f64, error: f64) -> Self {
        Interval::rounded(x - error, x + error)
    }

    fn rounded(low: f64, high: f64) -> Self {
        Interval::new(low.next_down(), high.next_up())
    }

    /// Whether every number of it is positive; what is not a number is not.
    pub(crate) fn is_positive(self) -> bool {
        self.low > 0.0 && self.high < f64::INFINITY
    }

    /// From the least number of both to the largest.
    pub(crate) fn hull(self, other: Self) -> Self {
        Interval::new(self.low.min(other.low), self.high.max(other.high))
    }

    /// The numbers whose absolute value is at most `size` besides, of which there are some.
    pub(crate) fn within(self, size: f64) -> Self {
        Interval::new(self.low.max(-size), self.high.min(size))
    }

    /// The numbers up to the middle, and those from there on.
    pub(crate) fn halves(self) -> [Self; 2] {
        let middle = self.low / 2.0 + self.high / 2.0;
        [
            Interval::new(self.low, middle),
            Interval::new(middle, self.high),
        ]
    }

    /// How far its ends are apart.
    pub(crate) fn width(self) -> f64 {
        self.high - self.low
    }

    /// The largest absolute value; infinite where an end is not a number.
    pub(crate) fn size(self) -> f64 {
        let [low, high] = [self.low.abs(), self.high.abs()];
        if low.is_nan() || high.is_nan() {
            return f64::INFINITY;
        }
        low.max(high)
    }

    /// The smallest absolute value.
    pub(crate) fn least_size(self) -> f64 {
        self.low.max(-self.high).max(0.0)
    }

    /// The sines and the cosines of all angles: both have their extremes where the angle is a whole number of
    /// quarter turns, and are between their values at the ends elsewhere.
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let turn = Interval::symmetric(1.0);
        let is_short = self.high - self.low < TAU && self.size() < LARGEST_ANGLE;
        if !is_short {
            return (turn, turn);
        }
        let [(s, c), (s_high, c_high)] = [self.low, self.high].map(|end| circle_point(end, 0.0));
        let (mut sine, mut cosine) = (s.hull(s_high), c.hull(c_high));
        // One too many does no harm.
        let mut quarters = (self.low / FRAC_PI_2 - NEAR_QUARTER).ceil();
        while quarters <= self.high / FRAC_PI_2 + NEAR_QUARTER {
            let (extreme, end) = match quarters.rem_euclid(4.0) {
                0.0 => (&mut cosine, 1.0),
                1.0 => (&mut sine, 1.0),
                2.0 => (&mut cosine, -1.0),
                _ => (&mut sine, -1.0),
            };
            *extreme = extreme.hull(Interval::exact(end));
            quarters += 1.0;
        }
        (sine.within(1.0), cosine.within(1.0))
    }

    /// The quotient by an interval; everything where that holds zero.
    pub(crate) fn over(self, divisor: Self) -> Self {
        if divisor.low <= 0.0 && divisor.high >= 0.0 {
            return Interval::symmetric(f64::INFINITY);
        }
        Interval::of_ends([
            self.low / divisor.low,
            self.low / divisor.high,
            self.high / divisor.low,
            self.high / divisor.high,
        ])
    }

    fn of_ends(ends: [f64; 4]) -> Self {
        // `f64::min` would lose what is not a number.
        let least = |a: f64, b: f64| if a.is_nan() || b > a { a } else { b };
        let [a, b, c, d] = ends;
        let low = least(least(a, b), least(c, d));
        let high = -least(least(-a, -b), least(-c, -d));
        Interval::rounded(low, high)
    }
}

/// Beyond it, in rad, nothing is said of an angle's sine.
const LARGEST_ANGLE: f64 = 1e6;

/// How near to a whole number of quarter turns an angle counts as there: more than is lost of it by a division.
const NEAR_QUARTER: f64 = 1e-9;

/// Sine and cosine of all angles that differ from a double by so much at most: the slope of both is at most 1.
fn circle_point(angle: f64, difference: f64) -> (Interval, Interval) {
    let (s, c) = sin_cos(angle);
    let error = SINE_ERROR * (1.0 + angle.abs()) + difference;
    (Interval::around(s, error), Interval::around(c, error))
}

impl_operators! {
    impl [] for Interval;
    Add add |a, b| Interval::rounded(a.low + b.low, a.high + b.high);
    Sub sub |a, b| a + -b;
    Neg neg |a| Interval::new(-a.high, -a.low);
    Mul mul |a, b| {
        // Zero stays zero, so that what is not there costs no width.
        let zero = Interval::exact(0.0);
        let is_finite = |x: Self| x.low.is_finite() && x.high.is_finite();
        if a == zero && is_finite(b) || b == zero && is_finite(a) {
            return zero;
        }
        Interval::of_ends([a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high])
    };
}

/// Reads a table without symbolic parameters.
pub(crate) struct Intervals;

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

    /// The macro requires numbers before.
    fn field(&mut self, _: usize) -> Interval {
        Interval::exact(f64::NAN)
    }

    fn quotient(&mut self, a: Interval, b: Interval) -> Interval {
        a.over(b)
    }

    fn circle(&mut self, angle: &Value) -> (Interval, Interval) {
        let Interval { low, high } = self.value(angle);
        // The whole width, because taking quarter turns off an angle is rounded.
        circle_point(0.5 * low + 0.5 * high, high - low)
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

    /// At many angles of many ranges, short ones and ones with extremes in them.
    #[test]
    fn sines_of_ranges_hold_those_of_all_their_angles() {
        for k in -40..40 {
            let low = 0.37 * f64::from(k);
            for width in [0.0, 0.05, 0.9, 2.0, 4.0, 6.2, 7.0] {
                let (s, c) = Interval::new(low, low + width).sin_cos();
                assert!(s.size() <= 1.0 && c.size() <= 1.0);
                let (mut least, mut largest) = (1.0_f64, -1.0_f64);
                for step in 0..=100 {
                    let (sine, cosine) = sin_cos(low + 0.01 * f64::from(step) * width);
                    assert!(holds(s, sine.clamp(-1.0, 1.0)) && holds(c, cosine.clamp(-1.0, 1.0)));
                    (least, largest) = (least.min(sine), largest.max(sine));
                }
                // And not many more.
                assert!(
                    s.low > least - 2e-3 && s.high < largest + 2e-3,
                    "{low} {width}"
                );
            }
        }
        let (s, c) = Interval::symmetric(f64::INFINITY).sin_cos();
        assert_eq!([s, c], [Interval::symmetric(1.0); 2]);
    }

    #[test]
    fn sizes() {
        assert_eq!(Interval::new(-3.0, 1.0).size(), 3.0);
        assert_eq!(Interval::new(-3.0, 1.0).least_size(), 0.0);
        assert_eq!(Interval::new(-3.0, -1.0).least_size(), 1.0);
        assert_eq!(Interval::new(f64::NAN, 1.0).size(), f64::INFINITY);
        assert_eq!(
            Interval::new(-3.0, 1.0).within(2.0),
            Interval::new(-2.0, 1.0)
        );
    }
}
