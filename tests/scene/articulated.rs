//! `forward_dynamics_aba` where mass matrices are nearly singular, beside the factorisation of M.

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{
    DoubleDouble, Simulation, SingularMassMatrix, check_against_rnea, robot_dynamics,
};

macro_rules! vector {
    ($($x:expr),*) => {
        SVector::from([$($x),*])
    };
}

macro_rules! both {
    ($($table:tt)*) => {
        robot_dynamics! {
            $($table)*
            functions: [forward_dynamics, forward_dynamics_aba],
        }
    };
}

both! {
    /// A payload of a thousand million times the mass of the arm.
    struct HeavyPayload;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1, mass: 1 },
        elbow: revolute { a: 1, mass: 1e9, allow: [odd_mass] },
    ],
}

both! {
    /// The same, the masses known at run time.
    struct AnyPayload { m1: f64, m2: f64 }
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1, mass: m1 },
        elbow: revolute { a: 1, mass: m2 },
    ],
}

both! {
    /// Three joints, of which the outer two give way to the payload.
    struct LongReach;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1, mass: 1 },
        elbow: revolute { a: 1, mass: 1 },
        wrist: revolute { a: 1, mass: 1e9, allow: [odd_mass] },
    ],
}

both! {
    /// A wrist of massless links whose first and last axis nearly coincide.
    struct IdealWrist;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        roll: revolute { alpha: -PI/2 },
        pitch: revolute { alpha: PI/2 },
        yaw: revolute { mass: 1, com: [0, 0, 0.1], inertia: { xx: 0.001, yy: 0.001, zz: 0.001 } },
    ],
}

both! {
    /// The first link has no mass: it moves because the second one has inertia.
    struct MasslessFirst;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1 },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
}

both! {
    /// Nothing turns with the second joint.
    struct MasslessLast;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
        elbow: revolute { a: 1 },
    ],
}

type Solution<const N: usize> = Result<SVector<f64, N>, SingularMassMatrix>;

/// The error of both methods, relative to the largest acceleration: factored M, articulated bodies.
/// The reference is articulated bodies in 31 digits.
macro_rules! errors {
    ($robot:expr, $q:expr, $qd:expr, $tau:expr) => {{
        let (robot, q, qd, tau) = ($robot, $q, $qd, $tau);
        let [q_, qd_, tau_] = [q, qd, tau].map(|x| x.map(DoubleDouble::from));
        let reference = robot.forward_dynamics_aba(&q_, &qd_, &tau_);
        let reference = reference.expect("regular").map(|x| x.high());
        let error = |solution: Solution<_>| {
            (solution.expect("regular") - reference).amax() / reference.amax()
        };
        let errors = [
            error(robot.forward_dynamics(&q, &qd, &tau)),
            error(robot.forward_dynamics_aba(&q, &qd, &tau)),
        ];
        println!(
            "{:?}: {:.1e} {:.1e}",
            stringify!($robot),
            errors[0],
            errors[1]
        );
        (reference, errors)
    }};
}

/// The digits of a 113-bit computation.
fn assert_is<const N: usize>(found: SVector<f64, N>, expected: [&str; N]) {
    let expected = expected.map(|digits| digits.parse::<f64>().expect("a number"));
    let expected = SVector::from(expected);
    assert!(
        (found - expected).amax() <= 1e-15 * expected.amax(),
        "{found} {expected}"
    );
}

#[test]
fn a_heavy_payload_near_the_stretched_pose() {
    let state = (vector![0.3, 1e-4], vector![0.5, -0.4], vector![0.1, 0.2]);
    let digits = ["-24000.79201187816830154857", "47992.21231774643599616738"];
    let (reference, [factored, articulated]) = errors!(HeavyPayload, state.0, state.1, state.2);
    assert_is(reference, digits);
    // The simplified M knows that m1 + m2 - m2 cos^2 is m1 + m2 sin^2: no eight digits are lost.
    assert!(articulated <= 1e-15 && factored >= 1e3 * articulated);

    let arm = AnyPayload { m1: 1.0, m2: 1e9 };
    let (reference, [factored, articulated]) = errors!(arm, state.0, state.1, state.2);
    assert_is(reference, digits);
    assert!(articulated <= 1e-15 && factored >= 1e6 * articulated);
}

/// The directions in which the outer joints give way are turned into one another by the elbow.
#[test]
fn a_heavy_payload_behind_two_free_joints() {
    let (qd, tau) = (vector![0.5, -0.4, 0.3], vector![0.1, 0.2, -0.3]);
    for (q, bound) in [
        (vector![0.3, 1.5706, -1.5706], 1e-11),
        (vector![0.3, -1.5709, 1.5], 1e-9),
        (vector![0.3, 0.9, 1e-4], 1e-11),
        (vector![0.3, 1e-4, 1e-4], 1e-11),
    ] {
        let (_, [factored, articulated]) = errors!(LongReach, q, qd, tau);
        assert!(articulated <= bound, "{q}: {articulated:e}");
        assert!(100.0 * articulated <= factored);
    }
}

#[test]
fn a_wrist_near_its_singular_pose() {
    let (qd, tau) = (vector![0.3, 0.2, 0.1], vector![0.1, 0.1, 0.1]);
    // The bounds are what articulated bodies reach elsewhere, where products are rounded. Where the build fuses them
    // with sums, other digits are lost: 3.6e-9 at the last pose.
    let share = if cfg!(target_feature = "fma") {
        2.0
    } else {
        1.0
    };
    for (pitch, bound, digits) in [
        (
            1e-2,
            2.9e-14,
            [
                "-6.726774237949443734668981",
                "9.983503264166315313214163",
                "106.72703789204041298824",
            ],
        ),
        (
            1e-4,
            4.4e-11,
            [
                "-1122.727268867424211159264",
                "9.099835181803263661277373",
                "1222.727269253787864969621",
            ],
        ),
        (
            1e-6,
            3.0e-9,
            [
                "-112722.72727268879435782",
                "9.090998351818181373163619",
                "112822.7272726924329976531",
            ],
        ),
    ] {
        let (reference, [factored, articulated]) =
            errors!(IdealWrist, vector![0.1, pitch, 0.3], qd, tau);
        assert_is(reference, digits);
        let bound = share * bound;
        assert!(articulated <= bound && factored <= bound);
    }
}

#[test]
fn a_massless_link_is_no_reason_to_refuse() {
    for q in [vector![0.3, 0.7], vector![0.3, 0.0]] {
        let (reference, errors) = errors!(MasslessFirst, q, vector![0.5, -0.4], vector![0.1, 0.2]);
        assert!(reference.amax() > 1.0 && errors[1] <= 1e-15);
    }
}

#[test]
fn the_joint_without_inertia_is_named() {
    let (q, still) = (vector![0.3, 0.7], vector![0.0, 0.0]);
    let error = MasslessLast
        .forward_dynamics_aba(&q, &still, &still)
        .unwrap_err();
    assert_eq!((error.joint, error.relative_pivot), (1, 0.0));
    assert_eq!(
        Err(error),
        MasslessLast.forward_dynamics(&q, &still, &still)
    );
}

#[test]
fn both_forms_are_those_of_newton_and_euler() {
    check_against_rnea(&IdealWrist).assert_ok();
    check_against_rnea(&AnyPayload { m1: 2.0, m2: 3.0 }).assert_ok();
}

robot_dynamics! {
    struct Alone;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    functions: [forward_dynamics_aba, kinetic_energy, potential_energy],
}

/// The only forward dynamics of an arm is what a simulation takes.
#[test]
fn an_arm_can_be_simulated_by_articulated_bodies() {
    let motion = Simulation::new(&Alone).initial(vector![0.3, 0.2], vector![0.0, 0.0]);
    let motion = motion.run().expect("regular");
    let energy = |i: usize| {
        let (q, qd) = (&motion.q[i], &motion.qd[i]);
        Alone.kinetic_energy::<f64>(q, qd) + Alone.potential_energy::<f64>(q)
    };
    let last = motion.t.len() - 1;
    assert!((energy(last) - energy(0)).abs() < 1e-4 * energy(0).abs());
    assert!(motion.qd[last].amax() > 1.0);
}
