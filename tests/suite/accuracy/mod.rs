//! Every function of every robot against 25 digits, at 24 states each, angles of 1e6 rad included.
//!
//! The bound is 4e-15 times the number of joints, relative to the natural magnitude of the
//! quantity: 18 roundings for each joint. Run with `--nocapture` to see the errors.

mod errors;
mod functions;
mod quantity;

use errors::Errors;
use functions::quantities;
use quantity::Quantity;
use robots::*;
use testkit::references::{ReferenceFile, read};

/// The states of a robot's file, each with every quantity there.
fn states<const N: usize, const P: usize, R: Arm<N, P>>(
    robot: &R,
) -> impl Iterator<Item = (String, Vec<Quantity>)> {
    let file: ReferenceFile = read("reference", R::FILE);
    assert_eq!(file.states.len(), 24);
    file.states.into_iter().map(|state| {
        let quantities = quantities(robot, &state);
        (state.label, quantities)
    })
}

macro_rules! errors_of_all {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {
        vec![$(Errors::of(&$robot)),*]
    };
}

#[test]
fn every_function_of_every_robot_is_within_its_bound() {
    let errors = for_each_robot!(errors_of_all);
    println!("{}", errors[0].header());
    errors.iter().for_each(|robot| println!("{}", robot.line()));
    let failures: Vec<_> = errors.iter().flat_map(Errors::beyond_the_bound).collect();
    assert!(failures.is_empty(), "{failures:#?}");
}

/// The values of each function that the references have as zero at every state, with the
/// number of them that were computed as anything else, -0.0 among it.
fn vanishing<const N: usize, const P: usize, R: Arm<N, P>>(robot: &R) -> Vec<(String, usize)> {
    let states: Vec<_> = states(robot).map(|(_, quantities)| quantities).collect();
    let mut entries = Vec::new();
    for (k, quantity) in states[0].iter().enumerate() {
        // Its values are residuals, whose references are zero by definition.
        if quantity.function == "qdd" {
            continue;
        }
        let vanishes = |i: &usize| states.iter().all(|state| state[k].values[*i].1.is_zero());
        for i in (0..quantity.values.len()).filter(vanishes) {
            let non_zero = states
                .iter()
                .filter(|state| state[k].values[i].0.to_bits() != 0);
            let name = format!("{} {}[{i}]", R::FILE, quantity.function);
            entries.push((name, non_zero.count()));
        }
    }
    entries
}

macro_rules! vanishing_of_all {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {
        [$(vanishing(&$robot)),*].concat()
    };
}

#[test]
fn what_vanishes_identically_is_exactly_zero() {
    let mut entries = for_each_robot!(vanishing_of_all);
    // Entries of the matrices and vectors that no motion can change: as many as the files have, and 44 of the long arms.
    let of_long_arms = if cfg!(feature = "long_arms") { 44 } else { 0 };
    assert_eq!(entries.len(), 626 + of_long_arms);
    entries.retain(|(_, non_zero)| *non_zero > 0);
    assert!(entries.is_empty(), "{entries:#?}");
}
