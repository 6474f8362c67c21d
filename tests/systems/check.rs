//! The check against recursive Newton-Euler finds what is wrong with a model, and says where.

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{
    Model, State,
    check::{Evaluate, Evaluation},
    check_against_rnea, robot_dynamics,
    table::Table,
};

robot_dynamics! {
    /// Two links across each other, one of them on a slide.
    #[derive(Clone, Copy)]
    struct Arm { mass: f64, viscous: f64 }

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        turn: revolute { mass: mass, com: [0.3, 0.1, 0], inertia: cuboid(0.6, 0.2, 0.1) },
        slide: prismatic {
            a: 0.5, alpha: PI/2,
            mass: 1, com: [0, 0.1, 0.2],
            friction: { viscous: viscous, coulomb: 0.5 },
        },
    ],
    functions: [
        mass_matrix, coriolis_vector, gravity_vector, friction_vector, inverse_dynamics,
        forward_dynamics, kinetic_energy, potential_energy, bias_force, coriolis_matrix,
        coriolis_coefficients, centrifugal_coefficients, forward_kinematics, link_poses, jacobian,
        inverse_dynamics_derivatives, forward_dynamics_derivatives,
    ],
}

const RIGHT: Arm = Arm {
    mass: 2.0,
    viscous: 0.3,
};

/// A model whose functions are not those of its table.
struct Wrong(Arm);

impl Model<2> for Wrong {
    const JOINT_NAMES: [&'static str; 2] = Arm::JOINT_NAMES;

    fn table(&self) -> Table<2> {
        RIGHT.table()
    }
}

impl Evaluate<2> for Wrong {
    fn evaluate(&self, state: &State<2>, tau: &SVector<f64, 2>) -> Evaluation {
        self.0.evaluate(state, tau)
    }
}

/// The functions whose errors are beyond the tolerance.
fn failures(robot: &impl Evaluate<2>) -> Vec<&'static str> {
    let report = check_against_rnea(robot);
    let failed = report.functions.iter().filter(|f| !f.is_ok());
    let failed: Vec<_> = failed.map(|f| f.function).collect();
    assert_eq!(report.is_ok(), failed.is_empty());
    failed
}

#[test]
fn nothing_is_left_out() {
    let report = check_against_rnea(&RIGHT);
    report.assert_ok();
    let text = report.to_string();
    for function in [
        "mass_matrix",
        "coriolis_vector",
        "gravity_vector",
        "friction_vector",
        "inverse_dynamics",
        "forward_dynamics",
        "kinetic_energy",
        "potential_energy",
        "bias_force",
        "coriolis_matrix",
        "forward_kinematics",
        "link_poses",
        "jacobian",
        "inverse_dynamics_derivatives",
        "forward_dynamics_derivatives",
    ] {
        assert!(text.contains(function), "{function} is missing in:\n{text}");
    }
}

/// A millionth of a mass is found in every function that depends on it, and in no other.
#[test]
fn a_wrong_mass_is_found() {
    let failed = failures(&Wrong(Arm {
        mass: 2.000_002,
        ..RIGHT
    }));
    for function in [
        "mass_matrix",
        "inverse_dynamics",
        "forward_dynamics",
        "kinetic_energy",
        "forward_dynamics_derivatives",
    ] {
        assert!(failed.contains(&function), "{function} passed: {failed:?}");
    }
    for function in [
        "friction_vector",
        "forward_kinematics",
        "link_poses",
        "jacobian",
    ] {
        assert!(!failed.contains(&function), "{function} failed: {failed:?}");
    }
}

#[test]
fn a_wrong_friction_is_found() {
    let failed = failures(&Wrong(Arm {
        viscous: 0.300_001,
        ..RIGHT
    }));
    for function in [
        "friction_vector",
        "inverse_dynamics",
        "bias_force",
        "inverse_dynamics_derivatives",
        "forward_dynamics_derivatives",
    ] {
        assert!(failed.contains(&function), "{function} passed: {failed:?}");
    }
    assert!(!failed.contains(&"mass_matrix"));
}

#[test]
fn a_value_that_is_not_a_number_is_found() {
    let failed = failures(&Wrong(Arm {
        mass: f64::NAN,
        ..RIGHT
    }));
    assert!(failed.contains(&"mass_matrix"), "{failed:?}");
    assert!(failed.contains(&"kinetic_energy"), "{failed:?}");
}

#[test]
#[should_panic(expected = "mass_matrix")]
fn a_failed_check_panics_with_its_report() {
    check_against_rnea(&Wrong(Arm { mass: 2.5, ..RIGHT })).assert_ok();
}
