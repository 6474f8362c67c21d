use super::rounded::Magnitude;
use super::{Certified, Rounded};
use crate::random::SplitMix64;
use crate::{DoubleDouble, Scalar};

/// A precision whose errors it holds itself.
trait Number: Rounded<Magnitude = Self> + Magnitude {}

impl Number for f32 {}
impl Number for f64 {}

/// A number with its bound, and the exact one to 31 digits.
#[derive(Clone, Copy)]
struct Known<F: Number> {
    certified: Certified<F>,
    exact: DoubleDouble,
}

impl<F: Number> Known<F> {
    /// A random number of either sign, over some powers of ten, known to some error or exactly.
    fn random(random: &mut SplitMix64) -> Self {
        let sign = if random.within(&(-1.0..=1.0)) < 0.0 {
            -1.0
        } else {
            1.0
        };
        let size = libm::exp(random.within(&(-7.0..=7.0)));
        let value = F::from_f64(sign * size);
        let x = DoubleDouble::from(value.to_f64());
        let relative = libm::exp(random.within(&(-30.0..=-5.0)));
        let error = F::from_f64(relative) * value.magnitude();
        let off = DoubleDouble::from(error.to_f64() * random.within(&(-1.0..=1.0)));
        match random.within(&(0.0..=3.0)) as u8 {
            0 => Known {
                certified: Certified::exact(value),
                exact: x,
            },
            1 => Known {
                certified: Certified::from_f64(sign * size),
                exact: DoubleDouble::from(sign * size),
            },
            _ => Known {
                certified: Certified::with_error(value, error),
                exact: x + off,
            },
        }
    }

    #[track_caller]
    fn assert_holds(&self) {
        let value = DoubleDouble::from(self.certified.value().to_f64());
        let error = (value - self.exact).abs().high();
        let bound = self.certified.bound().to_f64();
        assert!(error <= bound, "{:?}: {error:e}", self.certified);
    }

    /// Whether more can be computed with it.
    fn is_useful(&self) -> bool {
        let size = self.certified.value().to_f64().abs();
        (1e-10..1e10).contains(&size) && self.certified.bound().to_f64() < 0.1 * size
    }
}

/// One of the operations, chosen by chance, on the exact number and in the arithmetic of the bounds.
fn operate<T: Scalar>(choice: u8, a: T, b: T, c: T) -> T {
    match choice {
        0 => a + b,
        1 => a - b,
        2 => a * b,
        3 => a / b,
        4 => a.mul_add(b, c),
        5 => (a * a + b * b).sqrt(),
        6 => a.sin_cos().0,
        7 => b.sin_cos().1,
        8 => Scalar::exp(-(a * a)),
        _ => a.sign() * b,
    }
}

/// The numbers of long random computations are never further from the exact ones than their bounds. Values are
/// those of the plain float.
fn random_computations<F: Number>() {
    let mut random = SplitMix64(5);
    let mut numbers: [Known<F>; 8] = core::array::from_fn(|_| Known::random(&mut random));
    let mut count = 0;
    for step in 0..40_000 {
        let mut any = || numbers[random.within(&(0.0..=7.999)) as usize];
        let (a, b, c) = (any(), any(), any());
        let choice = random.within(&(0.0..=9.999)) as u8;
        let found = Known {
            certified: operate(choice, a.certified, b.certified, c.certified),
            exact: operate(choice, a.exact, b.exact, c.exact),
        };
        found.assert_holds();
        let plain = operate(
            choice,
            a.certified.value(),
            b.certified.value(),
            c.certified.value(),
        );
        assert_eq!(
            plain.to_f64().to_bits(),
            found.certified.value().to_f64().to_bits()
        );
        numbers[step % 8] = if found.is_useful() {
            found
        } else {
            Known::random(&mut random)
        };
        count += u32::from(found.is_useful());
    }
    assert!(count > 10_000, "{count}");
}

/// Numbers of 31 digits that are wrong by as much as they may be, through all operations: what their own roundings add
/// is far below. At the ends of the errors bounds are nearly reached.
#[test]
fn bounds_hold_in_31_digits() {
    let mut random = SplitMix64(7);
    let mut largest = [0.0_f64; 9];
    for _ in 0..2000 {
        for (choice, largest) in largest.iter_mut().enumerate() {
            let [a, b, c] = core::array::from_fn(|_| {
                let x = random.within(&(0.5..=2.0));
                let error = 1e-20 * random.within(&(0.5..=1.0));
                let off = if random.within(&(0.0..=1.0)) < 0.5 {
                    error
                } else {
                    -error
                };
                let value = DoubleDouble::from(x);
                (
                    Certified::with_error(value, error),
                    value + DoubleDouble::from(off),
                )
            });
            let found = operate(choice as u8, a.0, b.0, c.0);
            let exact = operate(choice as u8, a.1, b.1, c.1);
            let error = (found.value() - exact).abs().high();
            assert!(error <= found.bound(), "{choice}: {error:e} {found:?}");
            *largest = largest.max(error / found.bound());
        }
    }
    assert!(largest.iter().all(|x| *x > 0.9), "{largest:?}");
}

/// Numbers near the end of the range may lose digits, and nothing is known of far angles.
#[test]
fn what_31_digits_do_not_hold_is_counted() {
    let [a, b] = [1.0 / 3.0, 2.0 / 7.0].map(|x| DoubleDouble::from(x) * DoubleDouble::from(1e-290));
    for x in [a * b, a - b, a / b, a.sqrt()] {
        assert!(x.rounding() >= f64::MIN_POSITIVE && x.magnitude() >= x.least_magnitude());
    }
    let far = Certified::exact(DoubleDouble::from(1e13)).sin_cos();
    assert_eq!(far.0.bound(), f64::INFINITY);
    let near = Certified::exact(DoubleDouble::from(1e6)).sin_cos();
    assert!(near.0.bound() < 1e-28 && near.1.bound() > 0.0);
}

/// The largest error of each operation over its bound, on operands that are exact or as wrong as they may be.
fn largest_ratios<F: Number>(relative_error: f64) -> [f64; 9] {
    let mut random = SplitMix64(6);
    core::array::from_fn(|choice| {
        let ratios = (0..3000).map(|_| {
            let [a, b, c] = core::array::from_fn(|_| {
                let value = F::from_f64(random.within(&(0.5..=2.0)));
                let error = value * F::from_f64(relative_error);
                let x = DoubleDouble::from(value.to_f64());
                let off = DoubleDouble::from(error.to_f64());
                let sides = [x + off, x - off];
                let exact = sides[usize::from(random.within(&(0.0..=1.0)) < 0.5)];
                (Certified::with_error(value, error), exact)
            });
            let found = operate(choice as u8, a.0, b.0, c.0);
            let exact = operate(choice as u8, a.1, b.1, c.1);
            let value = DoubleDouble::from(found.value().to_f64());
            (value - exact).abs().high() / found.bound().to_f64()
        });
        ratios.fold(0.0, f64::max)
    })
}

#[test]
fn bounds_of_single_operations_are_nearly_reached() {
    for relative_error in [0.0, 1e-13, 1e-3] {
        let ratios = largest_ratios::<f64>(relative_error);
        println!("relative error {relative_error:e}: {ratios:.3?}");
        assert!(ratios.iter().all(|x| (0.4..=1.0).contains(x)), "{ratios:?}");
    }
    let ratios = largest_ratios::<f32>(1e-3);
    assert!(ratios.iter().all(|x| (0.4..=1.0).contains(x)), "{ratios:?}");
}

#[test]
fn bounds_hold_in_double_precision() {
    random_computations::<f64>();
}

#[test]
fn bounds_hold_in_single_precision() {
    random_computations::<f32>();
}

#[test]
fn what_is_exact_has_no_error() {
    let [zero, one, x] = [0.0, 1.0, 0.3].map(Certified::exact);
    assert_eq!((x + zero).bound(), 0.0);
    assert_eq!((x - x).bound(), 0.0);
    assert_eq!((one + one).bound(), 0.0);
    assert_eq!((x * zero).bound(), 0.0);
    assert_eq!((zero / x).bound(), 0.0);
    assert_eq!(zero.sin_cos(), (zero, one));
    assert_eq!(x.sign(), one);
    assert_eq!(Scalar::mul_add(x, zero, x), x);
    assert_eq!(x.exact(0.1).bound(), 0.0);
}

#[test]
fn constants_are_rounded_numbers() {
    assert_eq!(Certified::<f64>::from_f64(0.0).bound(), 0.0);
    // 0.1 is 5.6e-18 away from its double, whose unit in the last place is 1.4e-17.
    let half_a_unit = f64::EPSILON / 32.0;
    assert_eq!(Certified::<f64>::from_f64(0.1).bound(), half_a_unit);
    let single = Certified::<f32>::from_f64(0.1);
    let distance = f64::from(0.1_f32) - 0.1;
    assert!(f64::from(single.bound()) >= distance + half_a_unit);
    assert!(f64::from(single.bound()) < 1.000_001 * distance);
    let next = 0.1_f32.next_up();
    let moved = single.rounded_once(next);
    assert_eq!(moved.value(), next);
    assert!(f64::from(moved.bound()) >= f64::from(next) - 0.1);
    let double = Certified::<f64>::from_f64(0.1);
    assert_eq!(double.rounded_once(next), double);
}

#[test]
fn nothing_is_known_of_a_quotient_by_what_may_be_zero() {
    let x = Certified::exact(1.0);
    let near_zero = Certified::with_error(1e-3, 1e-3);
    assert_eq!((x / near_zero).value(), 1000.0);
    for unknown in [
        x / near_zero,
        x / Certified::exact(0.0),
        near_zero - x / near_zero,
    ] {
        assert_eq!(unknown.bound(), f64::INFINITY);
        // And of all that is computed from it.
        for result in [
            unknown * Certified::exact(0.0),
            Certified::exact(0.0) / unknown,
            unknown.sin_cos().0,
            unknown.sign(),
            Scalar::exp(unknown),
            unknown.sqrt(),
        ] {
            assert_eq!(result.bound(), f64::INFINITY, "{result}");
        }
    }
    assert!((x / Certified::with_error(1e-3, 0.5e-3)).bound() >= 1000.0);
}

#[test]
fn the_root_of_what_may_be_negative_is_unknown() {
    assert_eq!(
        Certified::with_error(1.0, 2.0).sqrt().bound(),
        f64::INFINITY
    );
    assert_eq!(Certified::exact(-1.0).sqrt().bound(), f64::INFINITY);
    assert_eq!(Certified::exact(0.0).sqrt().bound(), 0.0);
}

#[test]
fn what_is_not_finite_is_unknown() {
    let large = Certified::exact(f64::MAX);
    for x in [
        large + large,
        large * large,
        Certified::exact(f64::NAN),
        -Certified::exact(f64::INFINITY),
    ] {
        assert_eq!(x.bound(), f64::INFINITY);
    }
    for error in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(Certified::with_error(1.0, error).bound(), f64::INFINITY);
    }
}

#[test]
fn signs_are_certain_beyond_the_error() {
    assert_eq!(
        Certified::with_error(-2.0, 1.0).sign(),
        Certified::exact(-1.0)
    );
    assert_eq!(Certified::with_error(-2.0, 2.0).sign().bound(), 2.0);
    assert_eq!(Certified::with_error(0.0, 1e-9).sign().bound(), 1.0);
    assert_eq!(Certified::exact(0.0).sign().bound(), 0.0);
}

/// Products below 2.2e-308 lose digits: up to half the least number.
#[test]
fn subnormal_results_are_off_by_up_to_half_the_least_number() {
    let scale = 2_f64.powi(600);
    let mut random = SplitMix64(8);
    for _ in 0..10_000 {
        let exponent = random.within(&(-330.0..=-300.0));
        let x = random.within(&(1.0..=10.0)) * 1e-150;
        let y = random.within(&(1.0..=10.0)) * libm::exp10(exponent + 150.0);
        let product = Certified::exact(x) * Certified::exact(y);
        let quotient = Certified::exact(x) / Certified::exact(1.0 / y);
        let exact = DoubleDouble::from(x * scale) * DoubleDouble::from(y);
        let error = (DoubleDouble::from(product.value() * scale) - exact).abs();
        assert!(error.high() <= product.bound() * scale, "{x:e} {y:e}");
        let exact = DoubleDouble::from(x * scale) / DoubleDouble::from(1.0 / y);
        let error = (DoubleDouble::from(quotient.value() * scale) - exact).abs();
        assert!(error.high() <= quotient.bound() * scale, "{x:e} {y:e}");
    }
}

#[test]
fn display_shows_both() {
    assert_eq!(
        Certified::with_error(0.25, 3e-17).to_string(),
        "0.25 +- 3.0e-17"
    );
}
