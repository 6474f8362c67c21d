//! No program loses digits: all functions of arms that are hard on them, in doubles and in single
//! precision.

mod digits;

use arms::{Arm, Arms, decimal, printed, robot};
use digits::Digits;
use dynamics_symbolic::Function;

/// PI/2 as books and files print it.
const RIGHT: [&str; 4] = ["1.5708", "1.570796", "1.5707963", "1.57079633"];

/// Angles next to right ones, masses that differ by eight powers of ten, unlucky fields.
#[test]
fn programs_of_hard_arms_lose_no_digits() {
    let digits = Digits::of_arms(1, 5);
    assert!(digits.programs() >= 150);
    digits.assert_none_lost();
}

mod release {
    use super::Digits;

    /// `cargo test --release -p dynamics-symbolic --test suite rounding::release -- --ignored`
    #[test]
    #[ignore = "minutes in a release build: run before a release"]
    fn ten_thousand_programs_of_hard_arms_lose_no_digits() {
        let seeds = [2, 3].map(|seed| std::thread::spawn(move || Digits::of_arms(seed, 240)));
        let [first, second] = seeds.map(|seed| seed.join().expect("all programs run"));
        let digits = first.join(second);
        assert!(digits.programs() >= 10_000);
        digits.assert_none_lost();
    }
}

/// Arms that are built, each with four right angles: every function with the first, which is the furthest
/// from a right angle, the default set with each.
#[test]
fn industrial_arms_lose_no_digits() {
    assert_industrial(&["stanford"]);
}

/// `cargo test -p dynamics-symbolic --test suite rounding:: -- --ignored`
#[test]
#[ignore = "takes a quarter of a minute: .ci/run runs it"]
fn longer_industrial_arms_lose_no_digits() {
    assert_industrial(&["panda", "puma560"]);
}

#[track_caller]
fn assert_industrial(names: &[&str]) {
    let mut digits = Digits::default();
    let mut arms = Arms::new(7);
    for name in names {
        for right in RIGHT {
            let number = right.parse().expect("a number");
            let arm = Arm {
                robot: printed(robot(name), &decimal(number)),
                fields: Vec::new(),
            };
            let functions = match right == RIGHT[0] {
                true => Function::ALL.to_vec(),
                false => Function::default_set(false),
            };
            digits.add(&arm, &functions, &mut arms, &format!("{name} with {right}"));
        }
    }
    digits.assert_none_lost();
}
