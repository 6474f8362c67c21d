//! The examples of the documentation, as they are written there.

use robot_dynamics::nalgebra::{Matrix2, Matrix4, SMatrix, SVector, Vector2, Vector6};
use robot_dynamics::{SingularMassMatrix, robot_dynamics};

robot_dynamics! {
    /// Two-link arm with point masses at the ends of its links.
    pub struct TwoLink { m1: f64, m2: f64, l1: f64, l2: f64, g: f64 }

    convention: modified,                 // `standard` or `modified`; no default
    gravity: [0, -g, 0],                  // acceleration of gravity in the base frame, m/s^2; no default
    joints: [
        shoulder: revolute { mass: m1, com: [l1, 0, 0] },
        elbow:    revolute { a: l1, mass: m2, com: [l2, 0, 0] },
    ],
}

robot_dynamics! {
    /// The first axis of a PUMA 560.
    pub struct Waist;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.67183, alpha: PI/2,
            inertia: { yy: 0.35 },
            motor: { inertia: 200e-6, gear_ratio: -62.6111 },
            friction: { viscous: 5.80182176795, coulomb: 25.9836065 },
        },
    ],
    functions: [inverse_dynamics, mass_matrix],
}

robot_dynamics! {
    /// Values in every form: bound names, degrees, parentheses, fields in angles.
    #[derive(Clone, Copy, Debug, Default)]
    struct Values { tilt: f64, scale: f64 }

    let inch = 0.0254;
    let reach = 2 * (10 * inch);
    convention: standard,
    gravity: [0, 0, -(9.81)],
    joints: [
        base: revolute { alpha: tilt, d: reach, a: scale * inch / 2, mass: 1 + scale },
        tip: prismatic { theta: deg(45), alpha: -deg(90), d: 1_0.5e-1, mass: 3, com: [1/4, -inch, 2.5] },
    ],
    tests: true,
}

const TWO_LINK: TwoLink = TwoLink {
    m1: 1.0,
    m2: 2.0,
    l1: 0.5,
    l2: 0.25,
    g: 9.81,
};

/// The default set: every function but those that are asked for by name, none of them missing.
#[test]
fn the_default_set_has_the_signatures_of_the_contract() {
    let [q, qd, qdd]: [Vector2<f64>; 3] = [[0.1, 0.2].into(), [0.3, 0.4].into(), [0.5, 0.6].into()];
    let mass_matrix: Matrix2<f64> = TWO_LINK.mass_matrix(&q);
    let sum = mass_matrix * qdd + TWO_LINK.coriolis_vector(&q, &qd) + TWO_LINK.gravity_vector(&q);
    let tau: Vector2<f64> = TWO_LINK.inverse_dynamics(&q, &qd, &qdd);
    assert!((tau - sum).norm() < 1e-14);
    let back = TWO_LINK
        .forward_dynamics(&q, &qd, &tau)
        .expect("a regular M");
    assert!((back - qdd).norm() < 1e-12);
    let kinetic: f64 = TWO_LINK.kinetic_energy(&q, &qd);
    let potential: f64 = TWO_LINK.potential_energy(&q);
    assert!(kinetic > 0.0 && potential > 0.0);
}

#[test]
fn a_model_knows_its_joints_and_its_table() {
    assert_eq!(TwoLink::DOF, 2);
    assert_eq!(TwoLink::JOINT_NAMES, ["shoulder", "elbow"]);
    let table = TWO_LINK.table();
    assert_eq!(table.gravity, [0.0, -9.81, 0.0]);
    assert_eq!(table.rows[1].a, 0.5);
    assert_eq!(table.rows[1].com, [0.25, 0.0, 0.0]);
}

#[test]
fn only_the_functions_asked_for_are_there() {
    let q = SVector::from([0.4]);
    assert_eq!(
        Waist.mass_matrix(&q)[0],
        0.35 + 200e-6 * 62.6111_f64.powi(2)
    );
    let rest = SVector::zeros();
    assert_eq!(Waist.inverse_dynamics(&q, &rest, &rest)[0], 0.0);
    // A trait that offers what was not asked for is reached, so that the inherent method is not
    // there.
    trait Absent {
        fn coriolis_vector(&self) {}
        fn forward_dynamics(&self) {}
        fn friction_vector(&self) {}
    }
    impl Absent for Waist {}
    Waist.coriolis_vector();
    Waist.forward_dynamics();
    Waist.friction_vector();
}

#[test]
fn values_are_constant_expressions() {
    let rows = Values {
        tilt: 0.3,
        scale: 2.0,
    }
    .table()
    .rows;
    assert_eq!((rows[0].alpha, rows[0].d, rows[0].a), (0.3, 0.508, 0.0254));
    assert_eq!(rows[0].mass, 3.0);
    assert_eq!(rows[1].theta, std::f64::consts::FRAC_PI_4);
    assert_eq!(rows[1].alpha, -std::f64::consts::FRAC_PI_2);
    assert_eq!(rows[1].d, 1.05);
    assert_eq!(rows[1].com, [0.25, -0.0254, 2.5]);
}

robot_dynamics! {
    /// Every function that is asked for by name.
    struct OnRequest;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        j1: revolute { mass: 1, com: [0.1, 0.2, 0.3] },
        j2: prismatic { alpha: PI/2, mass: 1, com: [0.3, 0.1, 0.2] },
        j3: revolute { a: 0.5, mass: 1, com: [0.1, 0, 0.2] },
    ],
    functions: [
        bias_force, coriolis_matrix, coriolis_coefficients, centrifugal_coefficients,
        forward_kinematics, link_poses, jacobian,
        inverse_dynamics_derivatives, forward_dynamics_derivatives, forward_dynamics_aba,
    ],
}

#[test]
fn functions_on_request_have_the_shapes_of_the_contract() {
    let q = SVector::from([0.1_f32, 0.2, 0.3]);
    let _: SVector<f32, 3> = OnRequest.bias_force(&q, &q);
    let _: SMatrix<f32, 3, 3> = OnRequest.coriolis_matrix(&q, &q);
    let _: SMatrix<f32, 3, 3> = OnRequest.coriolis_coefficients(&q);
    let _: SMatrix<f32, 3, 3> = OnRequest.centrifugal_coefficients(&q);
    let _: (SMatrix<f32, 3, 3>, SMatrix<f32, 3, 3>) =
        OnRequest.inverse_dynamics_derivatives(&q, &q, &q);
    let _: Result<(SMatrix<f32, 3, 3>, _, SMatrix<f32, 3, 3>), SingularMassMatrix> =
        OnRequest.forward_dynamics_derivatives(&q, &q, &q);
    let _: Result<SVector<f32, 3>, SingularMassMatrix> = OnRequest.forward_dynamics_aba(&q, &q, &q);
    let last: Matrix4<f32> = OnRequest.forward_kinematics(&q);
    let poses: [Matrix4<f32>; 3] = OnRequest.link_poses(&q);
    let jacobian: SMatrix<f32, 6, 3> = OnRequest.jacobian(&q);
    assert!((last - poses[2]).norm() < 1e-6);
    // The first axis is the base's z, and the second joint slides.
    assert_eq!(
        jacobian.fixed_view::<3, 1>(3, 0),
        SVector::from([0.0, 0.0, 1.0])
    );
    assert_eq!(
        jacobian.fixed_view::<3, 1>(3, 1),
        SVector::from([0.0, 0.0, 0.0])
    );
    assert_eq!(Vector6::from(jacobian.column(1)).norm(), 1.0);
}

/// The same arm with its right angle written in one of several ways.
macro_rules! right_angled {
    ($name:ident, $angle:expr, $mass:literal) => {
        robot_dynamics! {
            #[doc = "An arm whose axes are at right angles."]
            struct $name;
            convention: standard,
            gravity: [0, 0, -9.81],
            joints: [
                j1: revolute { d: 0.4, alpha: $angle, mass: $mass, com: [0.01, 0.1, 0.02] },
                j2: revolute { a: 0.3, theta: $angle, mass: $mass, com: [-0.1, 0.02, 0.1] },
                j3: revolute { a: 0.2, alpha: -($angle), mass: $mass, com: [-0.1, 0.03, 0.2] },
            ],
            functions: [inverse_dynamics, forward_kinematics],
        }
    };
}
right_angled!(InRadians, PI / 2, 1.5);
right_angled!(InDegrees, deg(90), 1.5);
right_angled!(InDecimals, 1.570796327, 1.5);

/// A right angle is exact however it is written, so that all three arms are the same to the bit.
#[test]
fn right_angles_are_exact_in_every_spelling() {
    let [q, qd, qdd] = [[0.3, -0.8, 1.1], [1.0, 2.0, -1.5], [0.5, -3.0, 2.0]].map(SVector::from);
    let tau = InRadians.inverse_dynamics(&q, &qd, &qdd);
    assert_eq!(InDegrees.inverse_dynamics(&q, &qd, &qdd), tau);
    assert_eq!(InDecimals.inverse_dynamics(&q, &qd, &qdd), tau);

    // At the origin every direction is an axis of the base.
    let pose: Matrix4<f64> = InDecimals.forward_kinematics(&SVector::zeros());
    assert!(
        pose.fixed_view::<3, 3>(0, 0)
            .iter()
            .all(|x| [-1.0, 0.0, 1.0].contains(x)),
        "{pose}"
    );
}

robot_dynamics! {
    /// A pendulum whose fields are named as the variables of generated code may be.
    struct Names { q: f64, qd: f64, k: f64, s1: f64, c1: f64, t1: f64, pi: f64, r#type: f64 }
    convention: standard,
    gravity: [q, 0, 0],
    joints: [
        r#loop: revolute {
            a: qd, mass: k, com: [-s1, c1, 0], inertia: { zz: t1 },
            motor: { inertia: pi, gear_ratio: r#type },
        },
    ],
    tests: true,
}

#[test]
fn fields_and_joints_may_have_any_name() {
    assert_eq!(Names::JOINT_NAMES, ["loop"]);
    let (q, qd, k, s1, c1, t1, pi) = (9.81, 2.0, 3.0, 0.5, 0.0, 0.25, 0.125);
    let arm = Names {
        q,
        qd,
        k,
        s1,
        c1,
        t1,
        pi,
        r#type: 4.0,
    };
    // m (a - l)^2 + I + n^2 J
    assert_eq!(
        arm.mass_matrix(&SVector::from([0.3]))[0],
        3.0 * 2.25 + 0.25 + 16.0 * 0.125
    );
}

/// A robot may be local to a function.
#[test]
fn robots_may_be_items_of_a_function() {
    robot_dynamics! {
        struct Local;
        convention: modified,
        gravity: [0, 0, -9.81],
        joints: [lift: prismatic { mass: 2 }],
    }
    assert_eq!(Local.gravity_vector(&SVector::from([1.0]))[0], 19.62);
}
