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

/// A table among traits whose methods have the names that generated code calls, and which are implemented for all types.
mod among_other_methods {
    #[expect(dead_code, reason = "they are there to be found in place of others")]
    trait ByReference {
        fn constant(&self) {}
        fn like(&self) {}
        fn sine(&self) {}
        fn cosine(&self) {}
        fn position(&self) {}
        fn velocity(&self) {}
        fn acceleration(&self) {}
        fn trial(&self) {}
        fn product(&self) {}
        fn solve(&self) {}
        fn turn(&self) {}
    }
    impl<A> ByReference for A {}

    #[expect(dead_code, clippy::wrong_self_convention, reason = "as above")]
    trait ByValue: Sized {
        fn map(self) {}
        fn mul_add(self) {}
        fn sin_cos(self) {}
        fn sign(self) {}
        fn as_slice(self) {}
    }
    impl<A> ByValue for A {}

    rd::robot_dynamics! {
        /// A point mass on two joints, which a tilt changes.
        pub(super) struct Arm { pub(super) tilt: f64 }
        convention: modified,
        gravity: [9.81, 0, 0],
        joints: [
            one: revolute { friction: { viscous: 0.1, coulomb: 0.2 } },
            two: revolute { a: 0.5, alpha: tilt, mass: 2, com: [0.5, 0, 0] },
        ],
        functions: [default, taylor_series, forward_kinematics, regressor, terms = (mass_matrix, gravity_vector)],
    }
}

#[test]
fn methods_of_other_traits_are_not_called() {
    let arm = among_other_methods::Arm { tilt: 0.3 };
    rd::check_against_rnea(&arm).assert_ok();
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
