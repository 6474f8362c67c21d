//! Batches of every length against single calls.

use robots::{Puma560, StickyArm};

use super::arms::FIELDS;
use super::values::{Arm, States, Values, assert_same};

/// The largest difference from a single call, in units in the last place of the largest number of
/// the batch: lanes fuse sums of products where a plain build does not.
const ULPS: f64 = 6.0;

/// Whether the lanes round as single functions do, which is where they fuse nothing: where they fuse, sines of batches
/// have digits of their own.
fn rounds_alike() -> bool {
    #[cfg(target_arch = "x86_64")]
    return !std::arch::is_x86_feature_detected!("fma");
    #[cfg(not(target_arch = "x86_64"))]
    return !cfg!(target_arch = "aarch64");
}

/// The largest difference of each function, in units in the last place.
fn differences<const N: usize>(a: &Values<N>, b: &Values<N>) -> [f64; 5] {
    let pairs = a.numbers().into_iter().zip(b.numbers());
    let each = pairs.map(|((_, a), (_, b))| {
        let (a, b) = (a.concat(), b.concat());
        let size = a.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let worst = a
            .iter()
            .zip(&b)
            .fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
        if worst == 0.0 {
            0.0
        } else {
            worst / (size * f64::EPSILON)
        }
    });
    each.collect::<Vec<_>>().try_into().unwrap()
}

fn every_length<const N: usize>(name: &str, arm: &impl Arm<N>) {
    let longest = 33;
    let states = States::random(longest, 7);
    let single = Values::single(arm, &states);
    let whole = Values::by_rows(arm, &states);
    let differences = differences(&single, &whole);
    println!("{name:10} M V G tau qdd, units in the last place: {differences:.2?}");
    assert!(differences.iter().all(|ulps| *ulps <= ULPS), "{name}");
    if rounds_alike() {
        assert_same(&single, &whole);
    }
    for length in 0..=longest {
        let states = states.truncated(length);
        let rows = Values::by_rows(arm, &states);
        assert_same(&rows, &Values::by_columns(arm, &states));
        // A state's values are the same whatever the others are, and however many.
        assert_same(&rows, &whole.truncated(length));
        assert_eq!(rows.error, None);
    }
}

/// Every operation that a program can have: sines, quotients, signs and exponentials, of joints of both kinds,
/// of numbers and of fields. More arms would say the same: each is compiled for every width of registers, in
/// both layouts.
#[test]
fn batches_of_every_length_are_single_calls() {
    every_length("puma560", &Puma560);
    every_length("fields", &FIELDS);
    every_length("sticky_arm", &StickyArm);
}
