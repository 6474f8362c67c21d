//! The error of the kernel is below one unit in the last place: proven, not sampled.
//!
//! The kernel itself runs on [`Enclosed`], which stands for all arguments of a short interval. It knows of each
//! number where the computed and the exact one are, and what each rounding before it contributes to their difference.
//! So an error that is made good later cancels, as that of 1 - x^2/2 does. The part that the polynomials leave out is
//! evaluated in 31 digits in the middle of the interval, with a bound of its slope.
//!
//! Below 2^-27 it takes no machine: what the kernel takes off x - d is a sixth of x^3, below 2^-56 x, and what
//! rounding that together with d loses is below 2^-74 x. The sine is x - d, rounded once, the cosine
//! 1 - x^2/2 + x d. The reduction is left.

use core::cell::Cell;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use core::ops::{Add, Mul, Neg, Sub};

use super::{C, S};
use crate::DoubleDouble;
use crate::sine::lanes::{Kernel as _, Lanes};

/// All numbers between two.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Interval(f64, f64);

impl Interval {
    fn new(low: f64, high: f64) -> Self {
        Interval(low.next_down(), high.next_up())
    }

    fn largest(self) -> f64 {
        self.0.abs().max(self.1.abs())
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, b: Self) -> Self {
        Interval::new(self.0 + b.0, self.1 + b.1)
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Interval(-self.1, -self.0)
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, b: Self) -> Self {
        let products = [self.0 * b.0, self.0 * b.1, self.1 * b.0, self.1 * b.1];
        let low = products.into_iter().fold(f64::INFINITY, f64::min);
        let high = products.into_iter().fold(f64::NEG_INFINITY, f64::max);
        if low == 0.0 && high == 0.0 {
            return Interval(0.0, 0.0);
        }
        Interval::new(low, high)
    }
}

/// In how many pieces of an interval the polynomials are compared with what they stand for.
const PIECES: u32 = 16;

/// More than the kernel has operations.
const MOST: usize = 48;

thread_local! {
    /// How many roundings there were.
    static ROUNDINGS: Cell<usize> = const { Cell::new(0) };
}

/// A number for all arguments of an interval.
#[derive(Clone, Copy)]
struct Enclosed {
    computed: Interval,
    /// Without any rounding.
    exact: Interval,
    /// computed - exact is the sum of these, each times a number between -1 and 1.
    errors: [Interval; MOST],
    /// The rounding of the operation itself, at most: half a unit.
    rounding: f64,
}

/// From |x| to the next larger number.
fn unit(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}

impl Enclosed {
    fn exactly(low: f64, high: f64) -> Self {
        let all = Interval(low, high);
        Enclosed {
            computed: all,
            exact: all,
            errors: [Interval(0.0, 0.0); MOST],
            rounding: 0.0,
        }
    }

    /// With one rounding more.
    fn rounded(mut self) -> Self {
        self.rounding = 0.5 * unit(self.computed.largest());
        self.errors[ROUNDINGS.get()] = Interval(self.rounding, self.rounding);
        ROUNDINGS.set(ROUNDINGS.get() + 1);
        self.computed = Interval::new(
            self.computed.0 - self.rounding,
            self.computed.1 + self.rounding,
        );
        self
    }

    /// All errors but that of the last operation.
    fn before_the_last_rounding(&self) -> f64 {
        let all: f64 = self.errors.iter().map(|e| e.largest()).sum();
        (all - self.rounding) * (1.0 + 1e-12)
    }

    /// A number that halves and doubles are exact of.
    fn is_power_of_two(&self) -> bool {
        self.exact.0 == self.exact.1 && self.exact.0.abs().log2().fract() == 0.0
    }
}

impl Add for Enclosed {
    type Output = Self;

    fn add(self, b: Self) -> Self {
        let sum = Enclosed {
            computed: self.computed + b.computed,
            exact: self.exact + b.exact,
            errors: core::array::from_fn(|k| self.errors[k] + b.errors[k]),
            rounding: 0.0,
        };
        // A difference of numbers within a factor of two of each other is exact (Sterbenz 1974).
        let (x, y) = (self.computed, -b.computed);
        let is_exact = x.0 > 0.0 && y.0 > 0.0 && x.1 <= 2.0 * y.0 && y.1 <= 2.0 * x.0;
        if is_exact { sum } else { sum.rounded() }
    }
}

impl Sub for Enclosed {
    type Output = Self;

    fn sub(self, b: Self) -> Self {
        let negative = Enclosed {
            computed: -b.computed,
            exact: -b.exact,
            errors: b.errors.map(|e| -e),
            ..b
        };
        self + negative
    }
}

impl Mul for Enclosed {
    type Output = Self;

    /// a' b' - a b = a' (b' - b) + b (a' - a)
    fn mul(self, b: Self) -> Self {
        let product = Enclosed {
            computed: self.computed * b.computed,
            exact: self.exact * b.exact,
            errors: core::array::from_fn(|k| {
                self.computed * b.errors[k] + b.exact * self.errors[k]
            }),
            rounding: 0.0,
        };
        if self.is_power_of_two() || b.is_power_of_two() {
            product
        } else {
            product.rounded()
        }
    }
}

impl Lanes for Enclosed {
    type Number = f64;

    fn constant(self, x: f64) -> Self {
        Enclosed::exactly(x, x)
    }

    fn product_from(self, _: Self, _: Self) -> Self {
        unreachable!("the reduction has it alone")
    }

    fn select_by_lowest_bit(self, _: Self, _: Self) -> Self {
        unreachable!("the reduction has it alone")
    }

    fn turned_by_bit<const BIT: u32>(self, _: Self) -> Self {
        unreachable!("the reduction has it alone")
    }

    fn all_within(self, _: f64) -> bool {
        true
    }
}

/// A polynomial's distance from a function: coefficients of the powers `first`, `first + 2`, ...
struct Distance {
    first: i32,
    coefficients: Vec<DoubleDouble>,
}

impl Distance {
    /// The distance of `constants`, with the sign that they have in the kernel, from the series of 1 / n! with
    /// alternating signs, the first of them `sign`.
    fn new(first: i32, constants: &[f64], sign: f64) -> Self {
        let term = |k: usize| {
            let power = first + 2 * k as i32;
            let factorial = (1..=power).fold(DoubleDouble::from(1.0), |product, i| {
                product * DoubleDouble::from(f64::from(i))
            });
            let alternating = if k.is_multiple_of(2) { sign } else { -sign };
            let series = DoubleDouble::from(alternating) / factorial;
            let constant = constants.get(k).copied().unwrap_or(0.0);
            DoubleDouble::from(constant) - series
        };
        Distance {
            first,
            coefficients: (0..13).map(term).collect(),
        }
    }

    /// The largest on an interval. Powers beyond 27 are below 1e-30.
    fn largest(&self, low: f64, high: f64) -> f64 {
        let width = (high - low) / f64::from(PIECES);
        let piece = |k| self.largest_near(low + (f64::from(k) + 0.5) * width, 0.5 * width);
        (0..PIECES).map(piece).fold(0.0, f64::max) * (1.0 + 1e-9) + 1e-30
    }

    /// The largest within `radius` of `middle`, by Taylor's theorem: value and slope in the middle, and the most that
    /// the second derivative can be.
    fn largest_near(&self, middle: f64, radius: f64) -> f64 {
        let x = DoubleDouble::from(middle);
        let zero = DoubleDouble::from(0.0);
        let start = (1..self.first).fold(DoubleDouble::from(1.0), |power, _| power * x);
        let terms = self.coefficients.iter().zip((self.first..).step_by(2));
        let (mut value, mut slope, mut curvature, mut power) = (zero, zero, 0.0, start);
        for (c, n) in terms {
            let n = f64::from(n);
            value += *c * power;
            slope += *c * power * DoubleDouble::from(n);
            let largest = (middle + radius) / middle;
            curvature += (*c * power).high().abs() * n * (n - 1.0) / middle * largest.powf(n - 2.0);
            power = power * x * x;
        }
        (value * x).abs().high() + slope.abs().high() * radius + 0.5 * curvature * radius * radius
    }
}

/// The error in units in the last place of an exact value in an interval, where `before` is the error of what the
/// last operation rounds. Next to a power of two, what is rounded may be beyond it and the exact value not: then it
/// is rounded towards the power.
fn units(before: f64, smallest: f64, largest: f64) -> f64 {
    let (low, high) = (unit(smallest), unit(largest));
    let below = (before + before.max(0.5 * low)) / low;
    if low == high {
        before / low + 0.5
    } else {
        below.max(before / high + 0.5)
    }
}

/// Every argument from 2^-27 to a little above pi/4, in intervals of a 64th of it, with any tail that the
/// reduction may leave: half a unit of the argument, and n P3 < 2^-60.
#[test]
fn polynomials_and_their_roundings_stay_below_one_unit() {
    let end = FRAC_PI_4 + 1e-6;
    let [of_sine, of_cosine] = [
        Distance::new(3, &S.map(|s| -s), -1.0),
        Distance::new(4, &C, 1.0),
    ];
    let (mut low, mut largest) = (2.0_f64.powi(-27), [0.0_f64; 2]);
    while low < end {
        let high = low * (1.0 + 2.0_f64.powi(-6));
        let tail = 2.0_f64.powi(-60) + 2.0_f64.powi(-53) * high;
        ROUNDINGS.set(0);
        let (sine, cosine) =
            f64::sin_cos_reduced(Enclosed::exactly(low, high), Enclosed::exactly(-tail, tail));
        // sin (x - d) = sin x - d cos x - ..., where the kernel has 1 - x^2/2 for cos x; the same of the cosine.
        let left_out = tail * high.powi(4) / 24.0 + tail * tail;
        let before = sine.before_the_last_rounding() + of_sine.largest(low, high) + left_out;
        let smallest = (low - tail) * (1.0 - low * low / 6.0) * (1.0 - 1e-15);
        largest[0] = largest[0].max(units(before, smallest, (high + tail).sin().next_up()));

        let left_out = tail * high.powi(3) / 6.0 + tail * tail;
        let before = cosine.before_the_last_rounding() + of_cosine.largest(low, high) + left_out;
        let smallest = (high + tail).cos() * (1.0 - 1e-15);
        largest[1] = largest[1].max(units(
            before,
            smallest,
            (low - tail).cos().min(1.0_f64.next_down()),
        ));
        low = high;
    }
    println!(
        "sine {:.3}, cosine {:.3} units in the last place",
        largest[0], largest[1]
    );
    assert!(largest.into_iter().all(|x| x < 0.95), "{largest:?}");
}

/// The part that the reduction leaves out, relative to what is left of the angle, is worst at the doubles nearest to
/// multiples of pi/2. Every multiple up to 1e5 rad: P3 is rounded, its product with n, and their difference
/// with the error of what is left of the first two.
#[test]
fn what_the_reduction_leaves_out_is_below_a_quarter_of_a_unit() {
    const P3: f64 = 1.06e-23;
    let half_turn_low = DoubleDouble::sum(6.123_233_995_736_766e-17, -1.497_384_904_859_183e-33);
    let mut worst = 0.0_f64;
    for n in 1..=63_662 {
        let n = f64::from(n);
        let multiple = DoubleDouble::from(n) * DoubleDouble::from(FRAC_PI_2);
        let low = DoubleDouble::from(n) * half_turn_low;
        let nearest = (multiple + low).high();
        let rest = ((DoubleDouble::from(nearest) - multiple) - low)
            .abs()
            .high();
        let left_out =
            n * (2.0_f64.powi(-130) + 2.0 * 2.0_f64.powi(-53) * P3) + 2.0_f64.powi(-105) * rest;
        worst = worst.max(left_out / rest);
    }
    let units = worst / 2.0_f64.powi(-53);
    println!("{units:.3} units in the last place");
    assert!(units < 0.25, "{units}");
}
