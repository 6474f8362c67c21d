//! Against integers, against values of 120 digits, and by identities.

use core::f64::consts::PI;

use super::DoubleDouble;
use crate::{Scalar, SingularMassMatrix};

/// u^2, u = 2^-53.
const SQUARED_UNIT: f64 = f64::EPSILON * f64::EPSILON / 4.0;

fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from(x)
}

/// Reproducible integers of up to `bits` bits, either sign.
fn integers(bits: u32, count: usize) -> impl Iterator<Item = i128> {
    let mut state = 1_u128;
    (0..count).map(move |_| {
        state = state
            .wrapping_mul(0x2360_ed05_1fc6_5da4_4385_df64_9fcc_f645)
            .wrapping_add(0x5851_f42d_4c95_7f2d_1405_7b7e_f767_814f);
        state as i128 >> (128 - bits)
    })
}

/// An integer of up to 106 bits, exactly.
fn of_integer(n: i128) -> DoubleDouble {
    let high = n as f64;
    DoubleDouble::sum(high, (n - high as i128) as f64)
}

/// The integer that a number is; its two parts are integers.
fn to_integer(x: DoubleDouble) -> i128 {
    x.high() as i128 + x.low() as i128
}

#[test]
fn integers_of_106_bits_are_exact() {
    for n in integers(105, 1_000) {
        assert_eq!(to_integer(of_integer(n)), n);
    }
}

#[test]
fn sums_and_products_of_integers_are_exact_where_they_fit() {
    let pairs = integers(104, 1_000).zip(integers(103, 1_500).skip(500));
    for (a, b) in pairs {
        assert_eq!(to_integer(of_integer(a) + of_integer(b)), a + b);
        assert_eq!(to_integer(of_integer(a) - of_integer(b)), a - b);
    }
    let pairs = integers(52, 1_000).zip(integers(53, 1_500).skip(500));
    for (a, b) in pairs {
        assert_eq!(to_integer(of_integer(a) * of_integer(b)), a * b);
    }
}

/// The bounds of the documentation. Sums of numbers of opposite signs are the hard ones: an
/// addition of the leading and the trailing parts alone loses all digits there.
#[test]
fn errors_of_the_operations_are_within_their_bounds() {
    let pairs = integers(100, 20_000).zip(integers(99, 20_500).skip(500));
    for (n, m) in pairs {
        let (a, b) = (of_integer(n), of_integer(m));
        // To 127 bits, by which the sum may be longer than a double-double is.
        let (large, small) = (n << 20, m);
        let error = to_integer(of_integer(n) * number(1_048_576.0) + b) - (large + small);
        assert!(error.abs() as f64 <= 3.0 * SQUARED_UNIT * (large + small).abs() as f64);
        if m == 0 {
            continue;
        }
        let quotient = a / b;
        let error = quotient * b - a;
        assert!(error.abs().high() <= 15.0 * SQUARED_UNIT * a.abs().high());
        let root = a.abs().sqrt();
        let error = root * root - a.abs();
        assert!(error.abs().high() <= 15.0 * SQUARED_UNIT * a.abs().high());
    }
}

/// Products of full length, of which the exact value is put together from three exact ones.
#[test]
fn errors_of_products_are_within_their_bound() {
    let pairs = integers(90, 20_000).zip(integers(90, 20_500).skip(500));
    for (n, m) in pairs {
        let halves = |n: i128| (n >> 45, n & ((1 << 45) - 1));
        let ((n1, n2), (m1, m2)) = (halves(n), halves(m));
        let terms = [
            (n1 * m1, 2_f64.powi(90)),
            (n1 * m2 + n2 * m1, 2_f64.powi(45)),
            (n2 * m2, 1.0),
        ];
        let product = of_integer(n) * of_integer(m);
        // Term by term, the largest first: each difference is exact or a correction.
        let error = terms.iter().fold(product, |rest, &(term, scale)| {
            rest - of_integer(term) * number(scale)
        });
        let size = product.abs().high();
        assert!(error.abs().high() <= 8.0 * SQUARED_UNIT * size, "{n} {m}");
    }
}

/// Square roots to 120 digits.
#[allow(clippy::approx_constant, reason = "a table")]
const ROOTS: [(f64, [f64; 2]); 5] = [
    (2.0, [1.4142135623730951, -9.667293313452913e-17]),
    (3.0, [1.7320508075688772, 1.0035084221806903e-16]),
    (0.1, [0.31622776601683794, 8.004969469767158e-19]),
    (1e200, [1e100, -3.103633000350474e+83]),
    (1e-200, [1e-100, -2.8941768603061505e-117]),
];

#[test]
fn roots_are_those_of_120_digits() {
    for (x, [high, low]) in ROOTS {
        let error = number(x).sqrt() - DoubleDouble::sum(high, low);
        assert!(error.abs().high() <= 4.0 * SQUARED_UNIT * high, "{x}");
    }
}

/// Angles with their sines and cosines to 120 digits.
#[allow(clippy::approx_constant, reason = "a table")]
const ANGLES: [(f64, [f64; 2], [f64; 2]); 19] = [
    (0.0, [0.0, 0.0], [1.0, 0.0]),
    (5e-324, [5e-324, 0.0], [1.0, 0.0]),
    (1e-200, [1e-200, 0.0], [1.0, 0.0]),
    (
        0.1,
        [0.09983341664682815, 3.08001512929492e-18],
        [0.9950041652780258, -5.50210156918377e-17],
    ),
    (
        0.7853981633974483,
        [0.7071067811865475, 4.1036934489363755e-17],
        [0.7071067811865476, -2.6687565161377232e-17],
    ),
    (
        0.7853981633974484,
        [0.7071067811865476, 8.519254961036853e-18],
        [0.7071067811865475, 5.830114366949665e-18],
    ),
    (
        1.0,
        [0.8414709848078965, 1.776845092935536e-18],
        [0.5403023058681398, -4.760954612604417e-17],
    ),
    (
        1.5707963267948966,
        [1.0, -1.874699728327322e-33],
        [6.123233995736766e-17, -1.4973849048591698e-33],
    ),
    (
        2.0,
        [0.9092974268256817, -1.4020906557816256e-17],
        [-0.4161468365471424, 1.990596398957495e-17],
    ),
    (
        3.141592653589793,
        [1.2246467991473532e-16, -2.99476980971834e-33],
        [-1.0, 7.498798913309288e-33],
    ),
    (
        -4.0,
        [0.7568024953079282, 4.892224089158451e-17],
        [-0.6536436208636119, 2.5846614087018284e-17],
    ),
    (
        6.283185307179586,
        [-2.4492935982947064e-16, 5.9895396194366814e-33],
        [1.0, -2.999519565323715e-32],
    ),
    (
        100.0,
        [-0.5063656411097588, -3.050947053792115e-18],
        [0.8623188722876839, 4.334809858136501e-17],
    ),
    (
        -100000.0,
        [-0.03574879797201651, -1.5429743706109861e-18],
        [-0.9993608074382124, -2.3447088905187402e-17],
    ),
    (
        1000000.0,
        [-0.34999350217129294, -1.5952848809323968e-17],
        [0.9367521275331447, 4.637088260214747e-17],
    ),
    (
        123456789.0,
        [0.9901147518020355, -8.980618906983069e-18],
        [0.14025968153390964, -5.935903437627408e-18],
    ),
    (
        10000000000.0,
        [-0.4875060250875107, -1.665199285246269e-17],
        [0.873119622676856, -5.41448904944852e-17],
    ),
    (
        -1000000000000000.0,
        [-0.8582727931702359, 2.372639689262412e-17],
        [-0.5131937377869703, 5.3179977268261675e-17],
    ),
    (
        7000000000000000.0,
        [0.807603186430403, 2.599553549171443e-17],
        [-0.5897262867360245, -1.8987668804434668e-17],
    ),
];

#[test]
fn sines_and_cosines_are_those_of_120_digits() {
    for (x, sine, cosine) in ANGLES {
        let (s, c) = number(x).sin_cos();
        for (found, [high, low]) in [(s, sine), (c, cosine)] {
            let error = found - DoubleDouble::sum(high, low);
            // Relative, which is more than is promised.
            assert!(error.abs().high() <= 1e-31 * high.abs(), "{x}: {error:?}");
        }
    }
}

/// Angles that have a second half, by the addition theorems.
#[test]
fn sines_of_sums_are_those_of_their_parts() {
    for n in integers(100, 2_000) {
        let x = of_integer(n) * number(2_f64.powi(-97));
        let y = number(x.high() * 0.7) + number(PI);
        let ((s, c), (t, d)) = (x.sin_cos(), y.sin_cos());
        let (sine, cosine) = (x + y).sin_cos();
        let errors = [s * d + c * t - sine, c * d - s * t - cosine];
        for error in errors {
            assert!(error.abs().high() < 2e-31, "{x:?} {error:?}");
        }
    }
}

#[test]
fn what_is_not_finite_propagates() {
    let (one, zero, infinity) = (number(1.0), number(0.0), number(f64::INFINITY));
    for x in [
        infinity + one,
        infinity * infinity,
        one / zero,
        infinity.sqrt(),
        infinity / one,
    ] {
        assert_eq!(x, infinity);
    }
    assert_eq!(number(1e200) * number(-1e200), -infinity);
    assert_eq!(one / infinity, zero);
    // Beyond the numbers whose halves do not overflow.
    let product = number(1e300) * number(1e-10);
    assert_eq!(product.high(), 1e300 * 1e-10);
    assert_eq!(product.low(), f64::mul_add(1e300, 1e-10, -product.high()));
    for x in [
        infinity - infinity,
        zero / zero,
        zero * infinity,
        (-one).sqrt(),
        number(f64::NAN) + one,
    ] {
        assert!(x.high().is_nan());
        assert!(!x.is_positive());
    }
    for x in [f64::NAN, f64::INFINITY, 1e16] {
        let (s, c) = number(x).sin_cos();
        assert!(s.high().is_nan() && c.high().is_nan());
    }
}

#[test]
fn signs_pivots_and_ratios() {
    assert_eq!(
        [2.5, -2.5, 0.0, -0.0].map(|x| number(x).sign().high()),
        [1.0, -1.0, 0.0, 0.0]
    );
    let third = number(1.0) / number(3.0);
    assert_eq!(third.ratio_to_f64(number(1.0)), 1.0 / 3.0);
    let pivot = |x| SingularMassMatrix::test(0, number(x), number(1.0));
    assert!(pivot(1e-29).is_ok() && pivot(1e-31).is_err());
}
