//! Numbers between two ends, with a bound on their error that holds for all of them.
//!
//! The rules are those of [`Bounded`](super::Bounded), over all points of a box instead of at one: |a| is the largest
//! absolute value of the exact number. Nothing is left out: bounds are rounded upwards, and underflow is counted.

use super::UNIT;
use crate::exact::Rational;
use crate::interval::Interval;
use crate::operators::impl_operators;

/// A number for each precision: double, and single.
pub(crate) type Each = [f64; 2];

/// A precision.
struct Precision {
    /// The largest relative error of one operation.
    unit: f64,
    /// The largest error of a result that underflows; in doubles bounds are rounded up by it.
    underflow: f64,
    /// Beyond it a result may overflow.
    largest: f64,
}

const PRECISIONS: [Precision; 2] = [
    Precision {
        unit: UNIT,
        underflow: 0.0,
        largest: f64::MAX / 4.0,
    },
    Precision {
        unit: f32::EPSILON as f64 / 2.0,
        underflow: f32::MIN_POSITIVE as f64 * f32::EPSILON as f64,
        largest: f32::MAX as f64 / 4.0,
    },
];

/// A number for each precision, from its index.
pub(super) fn each(of: impl FnMut(usize) -> f64) -> Each {
    core::array::from_fn(of)
}

/// A number over a box of points: the exact one is in `range`, and what is computed in each precision at most `error` away from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ranged {
    /// The exact numbers.
    pub(crate) range: Interval,
    /// The bounds; infinite where nothing is known.
    pub(crate) error: Each,
}

/// A result of operations on bounds, rounded upwards: next to it where it was rounded to nearest. Zero is exact.
pub(super) fn up(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.next_up() }
}

/// a + b, rounded upwards.
pub(super) fn plus(a: f64, b: f64) -> f64 {
    let is_exact = a == 0.0 || b == 0.0;
    if is_exact { a + b } else { up(a + b) }
}

/// a b, rounded upwards: more than zero unless one of them is. An unknown factor stays unknown, times zero too.
pub(super) fn times(a: f64, b: f64) -> f64 {
    if a != 0.0 && b != 0.0 {
        (a * b).next_up()
    } else if a < f64::INFINITY && b < f64::INFINITY {
        0.0
    } else {
        f64::INFINITY
    }
}

/// The square root of a^2 + b^2, rounded upwards.
pub(super) fn norm(a: f64, b: f64) -> f64 {
    up(plus(times(a, a), times(b, b)).sqrt())
}

/// The largest errors of rounding results of those sizes.
pub(super) fn rounding(sizes: Each) -> Each {
    each(|k| {
        let Precision {
            unit, underflow, ..
        } = PRECISIONS[k];
        match sizes[k] {
            0.0 => 0.0,
            size => times(size, unit).max(underflow),
        }
    })
}

/// The errors of a sum of numbers with these.
pub(super) fn sum(a: Each, b: Each) -> Each {
    each(|k| plus(a[k], b[k]))
}

impl Ranged {
    /// Numbers that are what they stand for.
    pub(crate) fn exact(range: Interval) -> Self {
        Ranged {
            range,
            error: [0.0; 2],
        }
    }

    /// Numbers that are known to some error.
    pub(crate) fn with_error(range: Interval, error: Each) -> Self {
        let bound = |k: usize| {
            let largest = PRECISIONS[k].largest;
            let is_known = error[k] <= largest && range.size() <= largest;
            if is_known { error[k] } else { f64::INFINITY }
        };
        Ranged {
            range,
            error: each(bound),
        }
    }

    /// An exact number that was rounded to the double `x`, or from there on to a single.
    pub(crate) fn rounded(x: f64) -> Self {
        let range = Interval::new(x.next_down(), x.next_up());
        Ranged::with_error(range, rounding([x.abs(); 2]))
    }

    /// A rational number, exact where the double `x` is the number, and in single precision where that has it too; else rounded.
    pub(crate) fn rational(exact: &Rational, x: f64) -> Self {
        let mut rounded = Ranged::rounded(x);
        if Rational::try_from(x).is_ok_and(|x| x == *exact) {
            let single = if f64::from(x as f32) == x {
                0.0
            } else {
                rounded.error[1]
            };
            rounded = Ranged::with_error(Interval::exact(x), [0.0, single]);
        }
        rounded
    }

    /// The largest sizes of what is computed.
    pub(super) fn computed(self) -> Each {
        self.error.map(|error| plus(self.range.size(), error))
    }

    /// The exact numbers and the computed ones, of single precision too where its errors are known.
    pub(super) fn wide(self) -> Interval {
        let [double, single] = self.error;
        let error = if single < f64::INFINITY {
            single
        } else {
            double
        };
        self.range + Interval::symmetric(error)
    }

    /// A result that is rounded once, from operands that contribute `error`.
    pub(super) fn from_operands(range: Interval, error: Each) -> Self {
        let rounding = rounding(error.map(|error| plus(range.size(), error)));
        Ranged::with_error(range, sum(error, rounding))
    }
}

impl_operators! {
    impl [] for Ranged;
    Neg neg |a| Ranged { range: -a.range, ..a };
    Add add |a, b| Ranged::from_operands(a.range + b.range, sum(a.error, b.error));
    Mul mul |a, b| {
        let (size, computed) = (a.range.size(), b.computed());
        let passed_on = each(|k| plus(times(size, b.error[k]), times(computed[k], a.error[k])));
        Ranged::from_operands(a.range * b.range, passed_on)
    };
    /// |a'/b' - a/b| <= (e_a + |a/b| e_b) / (|b| - e_b)
    Div div |a, b| {
        let range = a.range.over(b.range);
        let error = |k: usize| {
            let room = (b.range.least_size() - b.error[k]).next_down();
            let passed_on = plus(a.error[k], times(range.size(), b.error[k]));
            if room.is_nan() || room <= 0.0 {
                f64::INFINITY
            } else if passed_on == 0.0 {
                0.0
            } else {
                (passed_on / room).next_up()
            }
        };
        Ranged::from_operands(range, each(error))
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Rational, SplitMix64};

    /// A box of one number and its neighbours, what is computed for one of them, and that number.
    #[derive(Clone)]
    struct Known {
        ranged: Ranged,
        computed: f64,
        single: f32,
        exact: Rational,
    }

    fn rational(x: f64) -> Rational {
        Rational::try_from(x).expect("finite")
    }

    impl Known {
        fn assert_holds(&self) {
            let computed = [self.computed, f64::from(self.single)];
            for (computed, error) in computed.into_iter().zip(self.ranged.error) {
                let difference = rational(computed) - &self.exact;
                let bound = rational(error);
                assert!(
                    -&bound <= difference && difference <= bound,
                    "{:?}",
                    self.ranged
                );
            }
            let size = rational(self.ranged.range.size());
            assert!(-&size <= self.exact && self.exact <= size);
        }
    }

    /// Random expressions of points of random intervals, with the exact value beside the computed one.
    #[test]
    fn exact_results_are_within_the_bound_anywhere_in_the_box() {
        let mut random = SplitMix64::new(3);
        let mut finite = 0;
        for _ in 0..500 {
            let mut input = || {
                let (low, width) = (4.0 * random.unit() - 2.0, random.unit() - 0.5);
                let range = Interval::new(low, low + width.max(0.0));
                let single = (low + width.max(0.0) * random.unit()) as f32;
                let computed = f64::from(single);
                Known {
                    ranged: Ranged::exact(range.hull(Interval::exact(computed))),
                    computed,
                    single,
                    exact: rational(computed),
                }
            };
            let mut numbers = [(); 4].map(|()| input()).to_vec();
            for _ in 0..6 {
                let mut any =
                    || numbers[(random.next_u64() % numbers.len() as u64) as usize].clone();
                let (a, b) = (any(), any());
                let number = match random.next_u64() % 4 {
                    0 => Known {
                        ranged: a.ranged + b.ranged,
                        computed: a.computed + b.computed,
                        single: a.single + b.single,
                        exact: a.exact + b.exact,
                    },
                    1 => Known {
                        ranged: a.ranged + -b.ranged,
                        computed: a.computed - b.computed,
                        single: a.single - b.single,
                        exact: a.exact - b.exact,
                    },
                    3 if (a.ranged / b.ranged).error[1] < f64::INFINITY => Known {
                        ranged: a.ranged / b.ranged,
                        computed: a.computed / b.computed,
                        single: a.single / b.single,
                        exact: a.exact / b.exact,
                    },
                    _ => Known {
                        ranged: a.ranged * b.ranged,
                        computed: a.computed * b.computed,
                        single: a.single * b.single,
                        exact: a.exact * b.exact,
                    },
                };
                number.assert_holds();
                finite += 1;
                numbers.push(number);
            }
        }
        assert_eq!(finite, 3_000);
    }

    #[test]
    fn nothing_is_known_of_a_quotient_by_what_may_be_zero_or_of_what_overflows() {
        let one = Ranged::exact(Interval::exact(1.0));
        let around = Ranged::exact(Interval::symmetric(1e-3));
        assert_eq!((one / around).error, [f64::INFINITY; 2]);
        assert_eq!((one / around + one).error, [f64::INFINITY; 2]);
        let large = Ranged::exact(Interval::symmetric(1e300));
        assert_eq!((large * large).error, [f64::INFINITY; 2]);
        assert_eq!((large * large * -around).error, [f64::INFINITY; 2]);
    }

    #[test]
    fn what_underflows_is_counted() {
        let tiny = Ranged::exact(Interval::symmetric(1e-200));
        assert!((tiny * tiny).error.iter().all(|error| *error > 0.0));
        let zero = Ranged::exact(Interval::exact(0.0));
        assert_eq!((zero * tiny).error, [0.0; 2]);
    }
}
