//! The check of generated robots at the edges: singular arms, robots of few functions.

use robot_dynamics::{check::Check, check_against_rnea, robot_dynamics};

robot_dynamics! {
    /// Two point masses on the vertical axis of the waist wherever the elbow is upright: nothing
    /// resists the waist there.
    struct PointMasses { m1: f64, m2: f64 }

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { d: 0.4, mass: m1 },
        elbow: revolute { alpha: PI/2, mass: m2, com: [0.7, 0, 0] },
    ],
}

const POINT_MASSES: PointMasses = PointMasses { m1: 2.0, m2: 1.5 };

#[test]
fn an_arm_that_is_singular_at_some_states_passes() {
    let report = check_against_rnea(&POINT_MASSES);
    report.assert_ok();
    let forward = report
        .functions
        .iter()
        .find(|f| f.function == "forward_dynamics")
        .expect("most states are regular");
    assert!(
        forward.states > 100 && forward.states < report.states,
        "{report}"
    );
    assert!(!report.to_string().contains("not compared"), "{report}");
}

#[test]
fn bounds_of_rounding_stand_beside_the_errors() {
    let report = check_against_rnea(&POINT_MASSES);
    assert!(report.to_string().contains("  rounding  "), "{report}");
    for function in &report.functions {
        let rounding = function.rounding.expect("the arm is a generated one");
        // Near the stretched pose, where M is singular, nothing is certain of accelerations.
        let is_solved = function.function == "forward_dynamics";
        assert!(
            rounding > 1e-17 && (rounding < 1e-14 || is_solved),
            "{report}"
        );
        assert!(function.error <= rounding + 1e-15, "{report}");
    }
    let plain = Check::new().run(&POINT_MASSES);
    assert!(plain.functions.iter().all(|f| f.rounding.is_none()));
    assert!(!plain.to_string().contains("rounding"), "{plain}");
}

#[test]
fn what_is_compared_nowhere_is_said() {
    let report = check_against_rnea(&PointMasses { m1: 2.0, m2: 0.0 });
    report.assert_ok();
    assert_eq!(report.not_compared, ["forward_dynamics"]);
    let line = "\nforward_dynamics: not compared at any state";
    assert!(report.to_string().contains(line), "{report}");
}

robot_dynamics! {
    struct CoriolisOnly { mass: f64 }

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        turn: revolute { a: 0.3, alpha: PI/2, mass: mass, com: [-0.1, 0.05, 0], inertia: rod(0.3) },
        lift: revolute { a: 0.4, alpha: 0.3, mass: 1.2, com: [-0.2, 0, 0.1], inertia: rod(0.4) },
        slide: prismatic { a: 0.1, alpha: 0.2, mass: 0.8, com: [0, 0.1, 0.2] },
    ],
    functions: [coriolis_coefficients],
    tests: true,
}

robot_dynamics! {
    struct CentrifugalOnly { mass: f64 }

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        turn: revolute { a: 0.3, alpha: PI/2, mass: mass, com: [-0.1, 0.05, 0], inertia: rod(0.3) },
        lift: revolute { a: 0.4, alpha: 0.3, mass: 1.2, com: [-0.2, 0, 0.1], inertia: rod(0.4) },
        slide: prismatic { a: 0.1, alpha: 0.2, mass: 0.8, com: [0, 0.1, 0.2] },
    ],
    functions: [centrifugal_coefficients],
    tests: true,
}

robot_dynamics! {
    /// One joint has no pair of joints: the matrix of the pairs has no columns.
    struct NoPair;

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [turn: revolute { mass: 1, com: [0.5, 0, 0] }],
    functions: [coriolis_coefficients],
    tests: true,
}

#[test]
fn coefficients_are_compared_alone() {
    let coriolis = check_against_rnea(&CoriolisOnly { mass: 2.0 });
    let centrifugal = check_against_rnea(&CentrifugalOnly { mass: 2.0 });
    for (report, name) in [
        (coriolis, "coriolis_coefficients"),
        (centrifugal, "centrifugal_coefficients"),
    ] {
        report.assert_ok();
        assert_eq!(report.functions.len(), 1);
        assert_eq!(report.functions[0].function, name);
        assert_eq!(report.functions[0].states, report.states);
    }
}

robot_dynamics! {
    /// Ten digits of pi/2 beside a field: the engine takes them for a quarter turn.
    struct TenDigits { off: f64 }

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        a: revolute { a: 1, alpha: off + 1.5707963268, mass: 1, com: [-0.5, 0, 0] },
        b: revolute { a: 1, theta: 1.5707963268 - off, mass: 1, com: [0.1, 0.2, 0.3] },
    ],
    tests: true,
}

robot_dynamics! {
    /// Angles of many turns, whose doubles are known to 1e-10 rad.
    struct ManyTurns { off: f64 }

    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [
        a: revolute { a: 1, alpha: 10000001*PI/7, mass: 1, com: [-0.5, 0, 0] },
        b: revolute { a: 1, alpha: off + 10000001*PI/7, theta: 1234567.1, mass: 1, com: [0.1, 0.2, 0.3] },
        c: revolute { a: 1, theta: -1234567.1 - off, mass: 1, com: [0.1, 0.2, 0.3] },
        d: revolute { a: 0.5, mass: 1, com: [0.3, 0.2, 0.1] },
    ],
    lock: [c = 7654321.3],
    tests: true,
    allow: [odd_angle],
}

/// The table means the arm that the functions were derived from.
#[test]
fn angles_of_the_table_are_those_of_the_functions() {
    for off in [0.3, -2.9, 1e6, -123_456.7] {
        check_against_rnea(&TenDigits { off }).assert_ok();
        check_against_rnea(&ManyTurns { off }).assert_ok();
    }
}
