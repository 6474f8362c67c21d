//! Robots with branches: values that other projects print, and generated functions beside Newton-Euler.

use core::f64::consts::PI;

use robot_dynamics::nalgebra::{SVector, Vector3};
use robot_dynamics::{NewtonEuler, State, check_against_rnea, robot_dynamics};

robot_dynamics! {
    /// The tree of five joints of RBDL's `CalcDynamicSimpleTree3D` (`DynamicsTests.cc`). Each joint's z axis is turned into
    /// the axis that RBDL names.
    pub struct Five;
    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [
        one: revolute { mass: 1, com: [1, 0, 0], inertia: { xx: 1, yy: 1, zz: 1 } },
        two: revolute {
            at: { xyz: [1, 0, 0], rpy: [-PI/2, 0, 0] }, mass: 1, com: [0, 0, 1], inertia: { xx: 1, yy: 1, zz: 1 },
        },
        three: revolute {
            at: { xyz: [0, 0, 1], rpy: [0, PI/2, 0] }, mass: 1, com: [0, -1, 0], inertia: { xx: 1, yy: 1, zz: 1 },
        },
        four: revolute {
            on: one, at: { xyz: [-0.5, 0, 0], rpy: [-PI/2, 0, 0] }, mass: 1, com: [0, 0, 1], inertia: { xx: 1, yy: 1, zz: 1 },
        },
        five: revolute {
            at: { xyz: [0, 0, -0.5], rpy: [0, PI/2, 0] }, mass: 1, com: [0, -1, 0], inertia: { xx: 1, yy: 1, zz: 1 },
        },
    ],
}

robot_dynamics! {
    /// The Y of KDL's `treeinvdyntest.cpp`: two links on the first one, at L and at 2 L along it.
    pub struct Y { m: f64, moment: f64, l: f64 }
    convention: standard,
    gravity: [0, -9.8, 0],
    joints: [
        stem: revolute { mass: m, com: [l, 0, 0], inertia: { xx: 0, yy: 0, zz: moment } },
        left: revolute { at: { xyz: [l, 0, 0] }, mass: m, com: [l/2, 0, 0], inertia: { xx: 0, yy: 0, zz: moment } },
        right: revolute { on: stem, at: { xyz: [2*l, 0, 0] }, mass: m, com: [l/2, 0, 0], inertia: { xx: 0, yy: 0, zz: moment } },
    ],
}

robot_dynamics! {
    /// A waist with two arms, one of which ends in a gripper whose fingers move together, and a mast on the base.
    pub struct Torso { load: f64 }
    convention: modified,
    gravity: [0, 0, -9.81],
    base: { xyz: [0, 0, 0.8], rpy: [0, 0.1, 0] },
    joints: [
        waist:          revolute { mass: 9, com: [0, 0, 0.2], inertia: { xx: 0.1, yy: 0.1, zz: 0.05 } },
        left_shoulder:  revolute { gamma: PI/2, b: 0.4, a: 0.2, alpha: PI/2, mass: 2, com: [0.1, 0, 0] },
        left_elbow:     revolute { a: 0.3, mass: 1, com: [0.1, 0, 0], inertia: { xx: 0, yy: 0.01, zz: 0.01 }, friction: { viscous: 0.1 } },
        left_finger:    prismatic { at: { xyz: [0.3, 0, 0], rpy: [PI/2, 0, 0] }, mass: 0.1 },
        other_finger:   prismatic { on: left_elbow, at: { xyz: [0.3, 0, 0], rpy: [-PI/2, 0, 0] }, mass: 0.1 },
        right_shoulder: revolute { on: waist, gamma: -PI/2, b: 0.4, a: 0.2, alpha: PI/2, mass: 2, com: [0.1, 0, 0] },
        right_elbow:    revolute { a: 0.3, mass: 1, com: [0.1, 0, 0] },
        right_wrist:    revolute { a: 0.2, mass: 0.4, com: [0, 0, 0.1], inertia: { xx: 0.01, yy: 0.01, zz: 0.01 } },
        lift:           prismatic { on: base, at: { xyz: [1, 0, 0], rpy: [0, 0, PI/2] }, mass: 3 },
    ],
    frames: {
        left_hand:  { on: left_elbow, xyz: [0.3, 0, 0], mass: load, com: [0, 0, 0.05], inertia: sphere(0.04) },
        camera:     { on: waist, xyz: [0.1, 0, 0.5], rpy: [0, 0.3, 0], mass: 0.2 },
        right_hand: { on: right_wrist, xyz: [0, 0, 0.2], mass: 0.5, inertia: sphere(0.05) },
        corner:     { on: base, xyz: [0.1, 0.2, 0] },
        box_on_lift: { on: lift, xyz: [0, 0.3, 0], mass: 4, com: [0, 0.1, 0], inertia: cuboid(0.2, 0.3, 0.2) },
    },
    couple: [other_finger = left_finger],
    lock: [right_elbow = 0.4],
    functions: [
        default, center_of_mass, inverse_dynamics_derivatives, regressor, base_parameters,
        forward_kinematics(left_hand), jacobian(left_hand), jacobian_rate(left_hand), wrench_torques(left_hand),
        tool_velocity(right_hand), tool_acceleration(right_hand), operational_inertia_inverse(left_hand),
        jacobian(right_hand), forward_kinematics(corner), forward_kinematics(camera),
        grasp = (jacobian(right_hand), mass_matrix, jacobian(left_hand), forward_dynamics),
    ],
}

/// RBDL prints the accelerations at rest, with all joints at zero.
#[test]
fn the_tree_of_rbdl_has_the_accelerations_that_it_prints() {
    let printed = [
        -1.60319066147860E+00,
        -5.34396887159533E-01,
        4.10340466926070E+00,
        2.67198443579767E-01,
        5.30579766536965E+00,
    ];
    let zero = SVector::<f64, 5>::zeros();
    let generated = Five.forward_dynamics(&zero, &zero, &zero).expect("regular");
    let numeric = NewtonEuler::new(&Five.table());
    let [solved, articulated] = [
        numeric.forward_dynamics(&zero, &zero, &zero),
        numeric.forward_dynamics_aba(&zero, &zero, &zero),
    ];
    for found in [
        generated,
        solved.expect("regular"),
        articulated.expect("regular"),
    ] {
        assert!((found - SVector::from(printed)).amax() < 1e-13, "{found}");
    }
}

/// The torques that KDL's test computes by its formulas.
fn torques_of_y(&Y { m, moment, l }: &Y, state: &State<3>) -> Vector3<f64> {
    let State { q, qd, qdd } = state;
    let (mll, g) = (m * l * l, 9.8);
    let ie = moment + 0.25 * mll;
    let ([s2, s3], [c2, c3]) = ([q[1], q[2]].map(f64::sin), [q[1], q[2]].map(f64::cos));
    let [c1, c12, c13] = [q[0], q[0] + q[1], q[0] + q[2]].map(f64::cos);
    let (a1, a2, a3) = (qdd[0], qdd[1], qdd[2]);
    let (v1, v2, v3) = (qd[0], qd[1], qd[2]);
    Vector3::new(
        (3.0 * moment + 6.5 * mll + mll * c2 + 2.0 * mll * c3) * a1
            + (ie + 0.5 * mll * c2) * a2
            + (ie + mll * c3) * a3
            - 0.5 * mll * s2 * v2 * v2
            - mll * s3 * v3 * v3
            - mll * s2 * v1 * v2
            - 2.0 * mll * s3 * v1 * v3
            + m * g * (4.0 * l * c1 + 0.5 * l * c12 + 0.5 * l * c13),
        (ie + 0.5 * mll * c2) * a1 + ie * a2 + 0.5 * mll * s2 * v1 * v1 + 0.5 * m * g * l * c12,
        (ie + mll * c3) * a1 + ie * a3 + mll * s3 * v1 * v1 + 0.5 * m * g * l * c13,
    )
}

#[test]
fn the_y_of_kdl_has_the_torques_of_its_formulas() {
    let y = Y {
        m: 1.0,
        moment: 0.05,
        l: 0.5,
    };
    let numeric = NewtonEuler::new(&y.table());
    for k in 0..24 {
        let entry = |i: usize, size: f64| size * (1.7 * f64::from(k) + 2.3 * i as f64 + size).sin();
        let vector = |size: f64| Vector3::from_fn(|i, _| entry(i, size));
        let [q, qd, qdd] = [PI, 3.0, 10.0].map(vector);
        let expected = torques_of_y(&y, &State { q, qd, qdd });
        for found in [
            y.inverse_dynamics(&q, &qd, &qdd),
            numeric.inverse_dynamics(&q, &qd, &qdd),
        ] {
            assert!(
                (found - expected).amax() < 1e-13,
                "state {k}: {found} {expected}"
            );
        }
    }
}

#[test]
fn functions_of_trees_agree_with_newton_euler() {
    check_against_rnea(&Five).assert_ok();
    check_against_rnea(&Y {
        m: 2.0,
        moment: 0.1,
        l: 0.7,
    })
    .assert_ok();
    let report = check_against_rnea(&Torso { load: 1.5 });
    report.assert_ok();
    let at = |function: &str, frame: &str, method: Option<&str>| {
        let rows = report.functions.iter();
        let found = rows
            .filter(|row| (row.frame.as_deref(), row.method.as_deref()) == (Some(frame), method));
        found.filter(|row| row.function == function).count()
    };
    for (function, frame, method) in [
        ("jacobian", "left_hand", None),
        ("operational_inertia_inverse", "left_hand", None),
        ("forward_kinematics", "corner", None),
        ("jacobian", "left_hand", Some("grasp")),
        ("jacobian", "right_hand", Some("grasp")),
    ] {
        assert_eq!(
            at(function, frame, method),
            1,
            "{function} {frame} {method:?}"
        );
    }
    let of_frames = report.functions.iter().filter(|row| row.frame.is_some());
    assert_eq!(of_frames.count(), 10 + 2);
    assert!(rows_are_within(&report.functions, 1e-15 * 7.0), "{report}");
}

fn rows_are_within(rows: &[robot_dynamics::check::FunctionReport], bound: f64) -> bool {
    rows.iter().all(|row| row.error < bound)
}
