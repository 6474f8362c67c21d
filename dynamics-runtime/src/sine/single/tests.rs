//! Against sines in double precision, whose errors are 2^-29 of a unit in the last place here.

use crate::random::SplitMix64;
use crate::sine::tests::{levels, ulps_of_single as ulps};
use crate::sine::{Kernel, Sines, eight_singles, four_singles, one};

/// The largest error of the sines and cosines of the floats whose bits are in a range.
fn largest_error(bits: impl Iterator<Item = u32>) -> f64 {
    let mut largest = 0.0_f64;
    let mut bits = bits.peekable();
    while bits.peek().is_some() {
        let mut lanes = [0.0; 8];
        for (lane, bits) in lanes.iter_mut().zip(&mut bits) {
            *lane = f32::from_bits(bits);
        }
        let exact = f64::of_array(lanes.map(f64::from));
        for ((s, c), (sine, cosine)) in f32::of_array(lanes).into_iter().zip(exact) {
            largest = largest.max(ulps(s, sine)).max(ulps(c, cosine));
        }
    }
    largest
}

const LARGEST_ERROR: f64 = 0.85;

/// Every 3,989th number of both signs.
#[test]
fn errors_stay_below_one_ulp() {
    let largest = f32::LARGEST.to_bits();
    let signs = [0, 1 << 31];
    let error = largest_error(
        signs
            .into_iter()
            .flat_map(|sign| (sign..=sign | largest).step_by(3989)),
    );
    println!("largest error: {error} ulp");
    assert!(error < LARGEST_ERROR, "{error}");
}

/// Beyond the limit, among them the largest numbers and those nearest to multiples of pi/2.
#[test]
fn large_angles_are_reduced_exactly() {
    let (first, last) = (f32::LARGEST.to_bits() + 1, f32::MAX.to_bits());
    let error = largest_error((first..=last).step_by(2003).chain(last - 7..=last));
    println!("largest error: {error} ulp");
    assert!(error < LARGEST_ERROR, "{error}");
    // The single-precision number nearest to a multiple of pi/2 (Muller 2016, 11.3.2).
    let nearest = 16_367_173.0 * 72_f32.exp2();
    let (_, c) = one(nearest);
    assert!(ulps(c, f64::from(nearest).cos()) < LARGEST_ERROR, "{c}");
}

#[test]
fn special_values() {
    let [(s, c), (t, d)] = f32::of_array([0.0, -0.0]);
    assert!(s == 0.0 && s.is_sign_positive() && c == 1.0);
    assert!(t == 0.0 && t.is_sign_negative() && d == 1.0);
    let tiny = f32::from_bits(1);
    assert_eq!(f32::of_array([tiny, -tiny]), [(tiny, 1.0), (-tiny, 1.0)]);
    for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let [(s, c), (t, _)] = f32::of_array([x, 1.0]);
        assert!(s.is_nan() && c.is_nan() && !t.is_nan());
    }
}

/// Every number of lanes and every instruction set that the processor has.
#[test]
fn the_same_digits_everywhere() {
    let mut random = SplitMix64(3);
    for turn in 0..5_000 {
        let scale = [1.0, 10.0, 2e4, 1e9][turn % 4];
        let x: [f32; 20] = core::array::from_fn(|_| random.within(&(-scale..=scale)) as f32);
        let expected = x.map(one);
        assert_eq!(f32::of_array(x), expected);
        assert_eq!(f32::of_array([x[0], x[1]]), expected[..2]);
        assert_eq!(f32::of_array([x[0], x[1], x[2]]), expected[..3]);
        let [a, b, c, d, e, f, g, h] = *x.first_chunk().unwrap();
        for level in levels() {
            let in_four = four_singles(level, a, b, c, d);
            let in_eight = eight_singles(level, a, b, c, d, e, f, g, h);
            for (lane, pair) in expected[..4].iter().enumerate() {
                assert_eq!((in_four.0[lane], in_four.1[lane]), *pair, "{level:?}");
            }
            for (lane, pair) in expected[..8].iter().enumerate() {
                assert_eq!((in_eight.0[lane], in_eight.1[lane]), *pair, "{level:?}");
            }
        }
    }
}
