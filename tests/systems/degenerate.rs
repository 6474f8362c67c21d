//! Tables at the edge: without gravity, without friction, without mass.

use robot_dynamics::nalgebra::Vector2;
use robot_dynamics::{SingularMassMatrix, check_against_rnea, robot_dynamics};
use testkit::random::Random;

robot_dynamics! {
    /// An arm in free space, without friction.
    struct Weightless;

    convention: standard,
    gravity: [0, 0, 0],
    joints: [
        shoulder: revolute { a: 1, alpha: PI/2, mass: 2, com: [-0.5, 0.1, 0], inertia: rod(1) },
        elbow: revolute { a: 1, mass: 1, com: [-0.4, 0, 0.2], inertia: rod(1) },
    ],
    functions: [gravity_vector, friction_vector, potential_energy],
}

robot_dynamics! {
    /// A point mass m2 at the end of the second link; the first is a rod.
    struct PointMass { m2: f64 }

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
        elbow: revolute { a: 1, mass: m2 },
    ],
}

robot_dynamics! {
    /// An arm whose hand is a point on its own axis: no torque is needed to turn it.
    struct MasslessHand;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
        hand: revolute {},
    ],
}

fn random_states() -> impl Iterator<Item = [Vector2<f64>; 3]> {
    let mut random = Random::seeded(5);
    (0..20).map(move |_| [random.vector(3.0), random.vector(3.0), random.vector(10.0)])
}

#[test]
fn functions_asked_for_of_a_table_without_their_cells_are_zero() {
    for [q, qd, _] in random_states() {
        assert_eq!(Weightless.gravity_vector(&q), Vector2::zeros());
        assert_eq!(Weightless.friction_vector(&qd), Vector2::zeros());
        assert_eq!(Weightless.potential_energy(&q), 0.0);
    }
}

#[test]
fn a_link_without_inertia_has_no_acceleration() {
    for [q, qd, tau] in random_states() {
        let refused = MasslessHand.forward_dynamics(&q, &qd, &tau);
        let error = refused.expect_err("nothing resists the hand");
        assert_eq!(error.joint, 1);
        assert!(error.to_string().contains("joint 2"), "{error}");
    }
}

#[test]
fn a_mass_of_zero_in_a_field_is_an_error_at_run_time() {
    for [q, qd, tau] in random_states() {
        let singular = PointMass { m2: 0.0 }.forward_dynamics(&q, &qd, &tau);
        assert_eq!(singular.expect_err("no inertia").joint, 1);
        let negative = PointMass { m2: -0.25 }.forward_dynamics(&q, &qd, &tau);
        assert!(negative.is_err(), "a negative mass was accepted");
        let regular = PointMass { m2: 0.25 }.forward_dynamics(&q, &qd, &tau);
        assert!(regular.is_ok(), "{regular:?}");
    }
}

#[test]
fn a_mass_that_is_not_a_number_is_an_error_at_run_time() {
    for [q, qd, tau] in random_states() {
        let arm = PointMass { m2: f64::NAN };
        match arm.forward_dynamics(&q, &qd, &tau) {
            Err(SingularMassMatrix { .. }) => {}
            Ok(qdd) => assert!(qdd.iter().all(|x| x.is_nan()), "{qdd}"),
        }
        assert!(
            arm.inverse_dynamics(&q, &qd, &tau)
                .iter()
                .all(|x| x.is_nan())
        );
    }
}

robot_dynamics! {
    /// An elbow arm whose gravity may point anywhere, or be switched off.
    struct AnyGravity { gx: f64, gy: f64, gz: f64 }
    convention: standard,
    gravity: [gx, gy, gz],
    joints: [
        waist: revolute { d: 0.5, alpha: PI/2, mass: 2, com: [0.1, -0.2, 0.05], inertia: sphere(0.1) },
        shoulder: revolute { a: 0.5, mass: 1.5, com: [-0.2, 0.02, 0], inertia: rod(0.5) },
        elbow: revolute { a: 0.4, mass: 1, com: [-0.2, 0, 0.01], inertia: rod(0.4) },
    ],
}

/// No function divides by a parameter that may be zero.
#[test]
fn parameters_may_be_zero() {
    for (gx, gy, gz) in [
        (0.0, -9.81, 0.0),
        (9.81, 0.0, 0.0),
        (0.0, 0.0, -1.62),
        (0.0, 0.0, 0.0),
    ] {
        check_against_rnea(&AnyGravity { gx, gy, gz }).assert_ok();
    }
}
