//! Against sines in double-double arithmetic.

use approx::{assert_abs_diff_eq, assert_relative_eq};

use super::vectors::halves;
use super::{Kernel, Part, Sines, eight, four, one, two};
use crate::random::SplitMix64;
use crate::{DoubleDouble, Scalar};
use core::f64::consts::{FRAC_PI_4, PI};
use fearless_simd::{Level, SimdFrom, dispatch, f64x4};

/// The error in units in the last place of the exact value.
pub(crate) fn ulps(computed: f64, exact: DoubleDouble) -> f64 {
    let error = (computed - exact.high()) - exact.low();
    let size = exact.high().abs();
    let ulp = (size.next_up() - size).max(f64::MIN_POSITIVE * f64::EPSILON);
    (error / ulp).abs()
}

/// The same for a number of single precision, where the exact value is a double.
pub(crate) fn ulps_of_single(computed: f32, exact: f64) -> f64 {
    let size = (exact as f32).abs();
    let ulp = (size.next_up() - size).max(f32::from_bits(1));
    ((f64::from(computed) - exact) / f64::from(ulp)).abs()
}

fn largest_error(angles: &[f64]) -> f64 {
    let mut largest = 0.0_f64;
    for chunk in angles.chunks_exact(8) {
        let lanes: [f64; 8] = chunk.try_into().unwrap();
        for (&x, (s, c)) in lanes.iter().zip(f64::of_array(lanes)) {
            let (sine, cosine) = DoubleDouble::from(x).sin_cos();
            largest = largest.max(ulps(s, sine)).max(ulps(c, cosine));
        }
    }
    largest
}

/// Reproducible angles: uniform in magnitude and uniform in exponent by turns.
pub(crate) fn angles(count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..count)
        .map(|i| {
            let sign = if next() < 0.5 { -1.0 } else { 1.0 };
            sign * match i % 4 {
                0 => next() * f64::LARGEST,
                1 => next() * 2.0 * PI,
                2 => next() * FRAC_PI_4,
                _ => (next() * 47.0 - 30.0).exp2().min(f64::LARGEST),
            }
        })
        .collect()
}

#[test]
fn errors_stay_below_one_ulp() {
    let largest = largest_error(&angles(200_000, 1));
    assert!(largest < 0.85, "{largest}");
}

/// The largest error at doubles near every so many-th multiple of pi/4, where digits cancel.
fn largest_error_where_digits_cancel(step: usize) -> f64 {
    let last = (f64::LARGEST / FRAC_PI_4) as i32;
    let near = (1..last).step_by(step).flat_map(|k| {
        let x = f64::from(k) * FRAC_PI_4;
        [x, x.next_up(), x.next_down(), -x]
    });
    let near: Vec<_> = near.filter(|x| x.abs() <= f64::LARGEST).collect();
    largest_error(&near)
}

#[test]
fn errors_stay_below_one_ulp_where_digits_cancel() {
    let largest = largest_error_where_digits_cancel(9);
    assert!(largest < 0.85, "{largest}");
}

#[test]
#[ignore = "takes seconds: .ci/run runs it"]
fn errors_stay_below_one_ulp_at_every_multiple() {
    let largest = largest_error_where_digits_cancel(1);
    assert!(largest < 0.85, "{largest}");
}

#[test]
fn special_values() {
    let [(s, c), (t, d)] = f64::of_array([0.0, -0.0]);
    assert!(s == 0.0 && s.is_sign_positive() && c == 1.0);
    assert!(t == 0.0 && t.is_sign_negative() && d == 1.0);
    let tiny = 5e-324;
    assert_eq!(f64::of_array([tiny, -tiny]), [(tiny, 1.0), (-tiny, 1.0)]);
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let [(s, c), (t, _)] = f64::of_array([x, 1.0]);
        assert!(s.is_nan() && c.is_nan() && !t.is_nan());
    }
}

#[test]
fn every_number_of_lanes_gives_the_same_digits() {
    fn same<const K: usize>(angles: &[f64]) {
        let array: [f64; K] = angles[..K].try_into().unwrap();
        for (&x, value) in array.iter().zip(f64::of_array(array)) {
            assert_eq!(f64::of_array([x]), [value]);
        }
    }
    for seed in 0..200 {
        let mut angles = angles(20, seed);
        same::<2>(&angles);
        same::<3>(&angles);
        same::<7>(&angles);
        same::<20>(&angles);
        angles[4] = 1e9;
        same::<7>(&angles);
    }
}

/// The instruction sets that this processor has.
pub(crate) fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let lesser = [
        best.as_sse2().map(Level::Sse2),
        best.as_sse4_2().map(Level::Sse4_2),
        best.as_avx2().map(Level::Avx2),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let lesser = [Some(Level::baseline())];
    lesser.into_iter().flatten().chain([best]).collect()
}

#[test]
fn every_instruction_set_gives_the_same_digits() {
    for level in levels() {
        for x in angles(10_000, 7).chunks_exact(8) {
            let [a, b, c, d, e, f, g, h] = x.try_into().unwrap();
            let expected: Vec<_> = x.iter().map(|&x| one(x)).collect();
            let in_eight = eight(level, a, b, c, d, e, f, g, h);
            // On some processors, eight are two times four.
            let in_halves = dispatch!(level, simd => {
                let half = |angles| f64x4::simd_from(simd, angles);
                halves(half([a, b, c, d]), half([e, f, g, h]))
            });
            assert_eq!(in_halves, Some(in_eight), "{level:?}");
            let in_four = four(level, a, b, c, d);
            let in_two = two(level, a, b);
            for (lane, &(s, c)) in expected.iter().enumerate() {
                assert_eq!((in_eight.0[lane], in_eight.1[lane]), (s, c), "{level:?}");
            }
            for (lane, &(s, c)) in expected[..4].iter().enumerate() {
                assert_eq!((in_four.0[lane], in_four.1[lane]), (s, c), "{level:?}");
            }
            for (lane, &(s, c)) in expected[..2].iter().enumerate() {
                assert_eq!((in_two.0[lane], in_two.1[lane]), (s, c), "{level:?}");
            }
        }
    }
}

/// Angles beyond [`f64::LARGEST`] with their sines and cosines, from integers of 2,600 bits.
const HUGE: [(f64, f64, f64); 8] = [
    (1.1e5, 0.271380632546237, 0.962472104675665),
    (-123456.789, 0.9986640823432246, 0.05167253271870138),
    (1e6, -0.34999350217129294, 0.9367521275331447),
    (1e9, 0.5458434494486996, 0.8378871813639024),
    (1e15, 0.8582727931702359, -0.5131937377869703),
    (1e22, -0.8522008497671888, 0.523214785395139),
    (1e300, -0.8178819121159085, -0.5753861119575491),
    (f64::MAX, 0.004961954789184062, -0.9999876894265599),
];

#[test]
fn huge_angles_are_reduced_exactly() {
    // The double nearest to a multiple of pi/2 of all (Kahan 1983; Muller 2016, 11.3.2).
    let nearest = 6_381_956_970_095_103.0 * 797_f64.exp2();
    let [(_, c)] = f64::of_array([nearest]);
    assert_abs_diff_eq!(c, -4.687_165_924_254_628e-19, epsilon = 1e-34);
    // Against sines of 1,200 bits.
    for (x, sine, cosine) in HUGE {
        let [(s, c)] = f64::of_array([x]);
        assert_relative_eq!(s, sine, max_relative = f64::EPSILON);
        assert_relative_eq!(c, cosine, max_relative = f64::EPSILON);
    }
}

/// Angles of every exponent, beside the sines of the `libm` crate (FreeBSD's): both are less than a
/// unit off.
#[test]
fn large_angles_have_the_sines_of_another_library() {
    let mut random = SplitMix64(17);
    for exponent in 17..1024 {
        for _ in 0..100 {
            let x = random.within(&(1.0..=2.0)) * 2.0_f64.powi(exponent - 1);
            let [(s, c), (t, d)] = f64::of_array([x, -x]);
            let (sine, cosine) = libm::sincos(x);
            assert_eq!((t, d), (-s, c));
            for (found, expected) in [(s, sine), (c, cosine)] {
                let unit = expected.abs().next_up() - expected.abs();
                assert!((found - expected).abs() <= unit, "{x}: {found} {expected}");
            }
        }
    }
}

/// One angle, of which a function reads a part: the digits that the part has beside the other.
#[test]
fn a_part_alone_has_the_same_digits() {
    fn same<F: Sines + PartialEq + std::fmt::Debug>(x: F) {
        let [(s, c)] = F::of_array([x]);
        let [(sine, _)] = F::parts_of_array([x], [Part::Sine]);
        let [(_, cosine)] = F::parts_of_array([x], [Part::Cosine]);
        assert_eq!([sine, cosine], [s, c], "{x:?}");
    }
    for x in angles(20_000, 11).into_iter().chain(HUGE.map(|(x, ..)| x)) {
        same(x);
        same((x as f32).clamp(f32::MIN, f32::MAX));
    }
    for x in [0.0, -0.0, 5e-324] {
        same(x);
        let [(sine, _)] = f64::parts_of_array([x], [Part::Sine]);
        assert_eq!(sine.to_bits(), x.to_bits());
    }
}
