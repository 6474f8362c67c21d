//! The macro in a crate that knows robot-dynamics as `rd`.
#![deny(warnings, missing_docs, unreachable_pub)]

use std::process::Command;

rd::robot_dynamics! {
    /// A hanging point mass.
    struct Pendulum;
    convention: modified,
    gravity: [9.81, 0, 0],
    joints: [pivot: revolute { mass: 2, com: [0.5, 0, 0] }],
    tests: true,
}

#[test]
fn a_dependency_may_have_another_name() {
    let (q, rest) = ([0.3].into(), [0.0].into());
    let tau: rd::nalgebra::Vector1<f64> = Pendulum.inverse_dynamics(&q, &rest, &rest);
    let expected = 2.0 * 9.81 * 0.5 * 0.3_f64.sin();
    assert!((tau[0] - expected).abs() < 4e-15 * 9.81, "{tau}");
}

/// `tests: true` makes a test, which runs with this one.
#[test]
fn the_generated_test_is_among_those_of_this_program() {
    let program = std::env::current_exe().expect("this program");
    let list = Command::new(program).arg("--list").output();
    let list = String::from_utf8(list.expect("a list").stdout).expect("text");
    let others = list.lines().filter(|line| line.ends_with(": test"));
    let generated: Vec<_> = others.filter(|line| line.contains("::")).collect();
    assert_eq!(generated.len(), 1, "{list}");
}
