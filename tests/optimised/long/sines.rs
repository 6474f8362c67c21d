//! Sines and cosines at so many angles that no test without optimisation could look at them.

use std::thread;

use robot_dynamics::{DoubleDouble, Scalar};
use testkit::random::Random;

/// In units in the last place; what is measured is 0.80.
const LARGEST_ERROR: f64 = 0.85;

/// The largest magnitudes that are reduced in lanes, rad.
const LARGEST: f64 = 1e5;
const LARGEST_SINGLE: f32 = 1e4;

/// The error of a double in units in the last place of the exact value.
fn ulps(computed: f64, exact: DoubleDouble) -> f64 {
    let size = exact.high().abs();
    let unit = (size.next_up() - size).max(f64::MIN_POSITIVE * f64::EPSILON);
    ((computed - exact.high() - exact.low()) / unit).abs()
}

/// The same for a single, where the exact value is a double.
fn ulps_of_single(computed: f32, exact: f64) -> f64 {
    let size = (exact as f32).abs();
    let unit = (size.next_up() - size).max(f32::from_bits(1));
    ((f64::from(computed) - exact) / f64::from(unit)).abs()
}

/// The larger result of the two halves of a search, which are looked through at a time.
fn by_halves(largest: impl Fn(usize) -> f64 + Sync) -> f64 {
    thread::scope(|scope| {
        let first = scope.spawn(|| largest(0));
        let second = largest(1);
        second.max(first.join().expect("the first half is looked through"))
    })
}

/// An angle of either sign: uniform up to the limit, a turn or pi/4, or uniform in its exponent, by turns.
fn angle(random: &mut Random, number: usize) -> f64 {
    use std::f64::consts::{FRAC_PI_4, TAU};
    match number % 4 {
        0 => random.between(-LARGEST, LARGEST),
        1 => random.between(-TAU, TAU),
        2 => random.between(-FRAC_PI_4, FRAC_PI_4),
        _ => {
            let size = random.between(-30.0, LARGEST.log2()).exp2();
            size.copysign(random.between(-1.0, 1.0))
        }
    }
}

#[test]
#[ignore = "3 s in a release build"]
fn errors_stay_below_one_unit_at_ten_million_angles() {
    let error = by_halves(|half| {
        let mut random = Random::seeded(half as u64);
        let mut largest = 0.0_f64;
        for first in (0..5_000_000).step_by(8) {
            let angles: [f64; 8] = std::array::from_fn(|i| angle(&mut random, first + i));
            for (&x, (s, c)) in angles.iter().zip(f64::sin_cos_array(angles)) {
                let (sine, cosine) = DoubleDouble::from(x).sin_cos();
                largest = largest.max(ulps(s, sine)).max(ulps(c, cosine));
            }
        }
        largest
    });
    println!("largest error: {error} units in the last place");
    assert!(error < LARGEST_ERROR, "{error}");
}

/// Positive numbers alone: those of the other sign have the same digits.
#[test]
#[ignore = "5 s in a release build"]
fn errors_stay_below_one_unit_at_every_single_number() {
    let middle = LARGEST_SINGLE.to_bits() / 2;
    let halves = [0..middle, middle..LARGEST_SINGLE.to_bits() + 1];
    let error = by_halves(|half| {
        let mut largest = 0.0_f64;
        for first in halves[half].clone().step_by(8) {
            let angles: [f32; 8] = std::array::from_fn(|i| f32::from_bits(first + i as u32));
            let exact = f64::sin_cos_array(angles.map(f64::from));
            for ((s, c), (sine, cosine)) in f32::sin_cos_array(angles).into_iter().zip(exact) {
                largest = largest
                    .max(ulps_of_single(s, sine))
                    .max(ulps_of_single(c, cosine));
            }
        }
        largest
    });
    println!("largest error: {error} units in the last place");
    assert!(error < LARGEST_ERROR, "{error}");
}
