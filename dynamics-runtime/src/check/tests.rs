//! The check passes what is right and finds what is wrong.

use nalgebra::{Matrix2, SVector, Vector2};

use super::accelerations::refused;
use crate::test_arms::{CRAIG_ARM, CraigArm};
use crate::{
    AccelerationDerivatives, Check, Evaluate, Evaluation, MAX_TAYLOR_ORDER, Model, NewtonEuler,
    Report, SecondDerivatives, SingularMassMatrix, State, Table, TaylorCoefficients,
    check_against_rnea,
};

/// The textbook arm with one value of its evaluation changed.
struct Damaged(fn(&State<2>, &mut Evaluation<2>));

impl Model<2> for Damaged {
    const JOINT_NAMES: [&'static str; 2] = CraigArm::JOINT_NAMES;

    fn table(&self) -> Table<2> {
        CRAIG_ARM.table()
    }
}

impl Evaluate<2> for Damaged {
    fn evaluate(&self, state: &State<2>, tau: &SVector<f64, 2>) -> Evaluation<2> {
        let mut evaluation = CRAIG_ARM.evaluate(state, tau);
        (self.0)(state, &mut evaluation);
        evaluation
    }
}

/// Names of the functions that do not pass.
fn wrong(report: &Report) -> Vec<&str> {
    let wrong = report.functions.iter().filter(|function| !function.is_ok());
    wrong.map(|function| function.function).collect()
}

fn check(damage: fn(&State<2>, &mut Evaluation<2>)) -> Report {
    Check::new().samples(20).run(&Damaged(damage))
}

#[test]
fn a_right_model_passes_with_room_to_spare() {
    let report = check_against_rnea(&CRAIG_ARM);
    report.assert_ok();
    assert_eq!(report.functions.len(), 8);
    for function in &report.functions {
        assert!(function.error < 1e-14, "{function}");
        assert_eq!(function.states, report.states);
    }
}

/// A relative change far above the tolerance and far below what a wrong term does.
const WRONG: f64 = 1.0 + 1e-9;

fn numeric() -> NewtonEuler<2> {
    NewtonEuler::new(&CRAIG_ARM.table())
}

/// B(q) and C(q), Craig (6.61).
fn coefficients(state: &State<2>) -> (Vector2<f64>, Matrix2<f64>) {
    let CraigArm { m2, l1, l2, .. } = CRAIG_ARM;
    let h = m2 * l1 * l2 * state.q[1].sin();
    (Vector2::new(-2.0 * h, 0.0), Matrix2::new(0.0, -h, h, 0.0))
}

fn force_derivatives(state: &State<2>) -> (Matrix2<f64>, Matrix2<f64>) {
    numeric().inverse_dynamics_derivatives(&state.q, &state.qd, &state.qdd)
}

fn second_derivatives(state: &State<2>) -> SecondDerivatives<f64, 2> {
    numeric().inverse_dynamics_second_derivatives(&state.q, &state.qd, &state.qdd)
}

fn acceleration_derivatives(state: &State<2>) -> AccelerationDerivatives<f64, 2> {
    let (by_position, by_velocity) = force_derivatives(state);
    let inverse = CRAIG_ARM.mass_matrix(&state.q).try_inverse().unwrap();
    (-inverse * by_position, -inverse * by_velocity, inverse)
}

fn taylor_series(state: &State<2>) -> TaylorCoefficients<f64, 2> {
    let State { q, qd, qdd } = state;
    let (by_position, by_velocity) = force_derivatives(state);
    let inverse = CRAIG_ARM.mass_matrix(q).try_inverse().unwrap();
    let jerk = -inverse * (by_position * qd + by_velocity * qdd);
    let mut series = [Vector2::zeros(); MAX_TAYLOR_ORDER + 1];
    series[..4].copy_from_slice(&[*q, *qd, qdd / 2.0, jerk / 6.0]);
    series
}

type Damage = (&'static str, fn(&State<2>, &mut Evaluation<2>));

/// One for each function.
const DAMAGES: [Damage; 23] = [
    ("mass_matrix", |_, e| {
        e.mass_matrix.as_mut().unwrap()[(1, 0)] *= WRONG;
    }),
    ("coriolis_vector", |_, e| {
        e.coriolis_vector.as_mut().unwrap()[1] *= WRONG;
    }),
    ("gravity_vector", |_, e| {
        e.gravity_vector.as_mut().unwrap()[0] *= WRONG;
    }),
    // The arm has no friction: anything but zero is wrong.
    ("friction_vector", |_, e| {
        e.friction_vector = Some(Vector2::new(1e-300, 0.0));
    }),
    // Nor has it springs.
    ("spring_vector", |_, e| {
        e.spring_vector = Some(Vector2::new(0.0, 1e-300));
    }),
    ("inverse_dynamics", |_, e| {
        e.inverse_dynamics.as_mut().unwrap()[1] *= WRONG;
    }),
    ("forward_dynamics", |_, e| {
        *e.forward_dynamics.as_mut().unwrap().as_mut().unwrap() *= WRONG;
    }),
    ("kinetic_energy", |_, e| {
        *e.kinetic_energy.as_mut().unwrap() *= WRONG;
    }),
    ("potential_energy", |_, e| {
        *e.potential_energy.as_mut().unwrap() *= WRONG;
    }),
    ("bias_force", |_, e| {
        e.bias_force.as_mut().unwrap()[0] *= WRONG;
    }),
    // C qd is V still: C' is no matrix of Christoffel symbols, though.
    ("coriolis_matrix", |state, e| {
        let State { q, qd, .. } = state;
        let shift = Matrix2::new(qd[1], -qd[0], 0.0, 0.0) * 1e-9;
        e.coriolis_matrix = Some(numeric().coriolis_matrix(q, qd) + shift);
    }),
    ("coriolis_coefficients", |state, e| {
        let (coriolis, _) = coefficients(state);
        e.coriolis_coefficients = Some(vec![coriolis * WRONG]);
    }),
    ("centrifugal_coefficients", |state, e| {
        let (_, centrifugal) = coefficients(state);
        e.centrifugal_coefficients = Some(centrifugal * WRONG);
    }),
    ("configuration_space_form", |state, e| {
        let v = numeric().coriolis_vector(&state.q, &state.qd);
        e.configuration_space_coriolis = Some(v * WRONG);
    }),
    ("forward_kinematics", |state, e| {
        e.forward_kinematics = Some(numeric().forward_kinematics(&state.q) * WRONG);
    }),
    ("link_poses", |state, e| {
        let mut poses = numeric().link_poses(&state.q);
        poses[0].m14 += 1e-9;
        e.link_poses = Some(poses);
    }),
    ("jacobian", |state, e| {
        let mut jacobian = numeric().jacobian(&state.q);
        jacobian[(5, 1)] *= WRONG;
        e.jacobian = Some(jacobian);
    }),
    ("regressor_form", |state, e| {
        let forces = numeric().inverse_dynamics(&state.q, &state.qd, &state.qdd);
        e.regressor_forces = Some(forces * WRONG);
    }),
    ("inverse_dynamics_derivatives", |state, e| {
        let (mut by_position, by_velocity) = force_derivatives(state);
        by_position[(1, 0)] *= WRONG;
        e.inverse_dynamics_derivatives = Some((by_position, by_velocity));
    }),
    ("forward_dynamics_derivatives", |state, e| {
        let (by_position, by_velocity, by_force) = acceleration_derivatives(state);
        e.forward_dynamics_derivatives = Some(Ok((by_position, by_velocity * WRONG, by_force)));
    }),
    ("inverse_dynamics_second_derivatives", |state, e| {
        let mut derivatives = second_derivatives(state);
        derivatives.3[0][(1, 1)] *= WRONG;
        e.inverse_dynamics_second_derivatives = Some(Box::new(derivatives));
    }),
    ("forward_dynamics_aba", |state, e| {
        e.forward_dynamics_aba = Some(Ok(state.qdd * WRONG));
    }),
    ("taylor_series", |state, e| {
        let mut series = taylor_series(state);
        series[3] *= WRONG;
        e.taylor_series = Some(Ok(series));
    }),
];

/// Each damage is found, in the function that has it and in no other.
#[test]
fn every_function_is_compared() {
    for (function, damage) in DAMAGES {
        assert_eq!(wrong(&check(damage)), [function]);
    }
}

/// The same values without the damage pass.
#[test]
fn kinematics_and_matrix_forms_pass() {
    let report = check(|state, e| {
        let State { q, qd, .. } = state;
        e.coriolis_matrix = Some(numeric().coriolis_matrix(q, qd));
        let (coriolis, centrifugal) = coefficients(state);
        e.coriolis_coefficients = Some(vec![coriolis]);
        e.centrifugal_coefficients = Some(centrifugal);
        e.configuration_space_coriolis = Some(numeric().coriolis_vector(q, qd));
        e.forward_kinematics = Some(numeric().forward_kinematics(q));
        e.link_poses = Some(numeric().link_poses(q));
        e.jacobian = Some(numeric().jacobian(q));
        e.friction_vector = Some(numeric().friction_vector(qd));
        e.spring_vector = Some(numeric().spring_vector(q));
        // Without springs and friction.
        e.regressor_forces = Some(numeric().inverse_dynamics(q, qd, &state.qdd));
        e.inverse_dynamics_derivatives = Some(force_derivatives(state));
        e.forward_dynamics_derivatives = Some(Ok(acceleration_derivatives(state)));
        e.inverse_dynamics_second_derivatives = Some(Box::new(second_derivatives(state)));
        e.forward_dynamics_aba = Some(Ok(state.qdd));
        e.taylor_series = Some(Ok(taylor_series(state)));
    });
    report.assert_ok();
    assert_eq!(report.functions.len(), DAMAGES.len());
}

/// The first coefficients of a series are those of its start, to the last digit.
#[test]
fn a_series_from_elsewhere_fails() {
    let damages: [fn(&State<2>, &mut Evaluation<2>); 3] = [
        |state, e| e.taylor_series = Some(Ok(shifted(state, 0))),
        |state, e| e.taylor_series = Some(Ok(shifted(state, 1))),
        |state, e| e.taylor_series = Some(Ok(shifted(state, 2))),
    ];
    for damage in damages {
        assert_eq!(wrong(&check(damage)), ["taylor_series"]);
    }
}

fn shifted(state: &State<2>, order: usize) -> TaylorCoefficients<f64, 2> {
    let mut series = taylor_series(state);
    series[order][1] += 1e-9;
    series
}

/// One base parameter that is the torque itself, and one that is a coefficient.
#[test]
fn combinations_take_both_functions() {
    let state = State {
        q: Vector2::new(0.3, 0.4),
        qd: Vector2::new(2.0, -3.0),
        qdd: Vector2::zeros(),
    };
    let regressor = Evaluation {
        regressor: Some(vec![Vector2::new(1.0, 2.0), Vector2::new(0.0, 1.0)]),
        ..Evaluation::default()
    };
    assert_eq!(regressor.clone().combined(&state.qd).regressor_forces, None);
    let both = Evaluation {
        base_parameters: Some(vec![3.0, 5.0]),
        ..regressor
    };
    let forces = both.combined(&state.qd).regressor_forces;
    assert_eq!(forces, Some(Vector2::new(3.0, 11.0)));

    let (coriolis, centrifugal) = coefficients(&state);
    let coriolis = Evaluation {
        coriolis_coefficients: Some(vec![coriolis]),
        ..Evaluation::default()
    };
    let alone = coriolis.clone().combined(&state.qd);
    assert_eq!(alone.configuration_space_coriolis, None);
    let both = Evaluation {
        centrifugal_coefficients: Some(centrifugal),
        ..coriolis
    };
    let found = both
        .combined(&state.qd)
        .configuration_space_coriolis
        .unwrap();
    let expected = numeric().coriolis_vector(&state.q, &state.qd);
    assert!((found - expected).amax() < 1e-12, "{found} {expected}");
}

/// The product is compared: one factor alone is not, and that is said.
#[test]
fn a_regressor_without_base_parameters_is_not_compared() {
    let report = check(|_, e| e.regressor = Some(Vec::new()));
    report.assert_ok();
    assert_eq!(report.not_compared, ["regressor"]);
    let line = "\nregressor: not compared at any state (that takes `base_parameters` too)";
    assert!(report.to_string().contains(line), "{report}");
}

#[test]
fn a_value_that_is_not_a_number_fails() {
    let report = check(|_, e| e.potential_energy = Some(f64::NAN));
    assert_eq!(wrong(&report), ["potential_energy"]);
    let report = check(|_, e| e.mass_matrix.as_mut().unwrap()[(0, 1)] = f64::NAN);
    assert_eq!(wrong(&report), ["mass_matrix"]);
    assert_eq!(report.functions[0].joint, Some(0));
}

#[test]
fn a_refusal_fails_where_the_mass_matrix_is_regular() {
    let report = check(|_, e| {
        e.forward_dynamics = Some(Err(SingularMassMatrix::new(1, 0.0)));
    });
    assert_eq!(wrong(&report), ["forward_dynamics"]);
    let function = report.functions.iter().find(|f| !f.is_ok()).unwrap();
    assert_eq!(function.joint, Some(1));
}

/// Without the outer mass the mass matrix is singular, and refusing it is right.
#[test]
fn a_refusal_passes_where_the_mass_matrix_is_singular() {
    let massless = CraigArm {
        m2: 0.0,
        ..CRAIG_ARM
    };
    let report = check_against_rnea(&massless);
    report.assert_ok();
    let names = report.functions.iter().map(|f| f.function);
    assert!(!names.collect::<Vec<_>>().contains(&"forward_dynamics"));
    assert_eq!(report.not_compared, ["forward_dynamics"]);
}

/// A joint that moves a thousandth of a millionth of the largest inertia is small, not singular.
#[test]
fn a_refusal_fails_where_one_inertia_is_small() {
    let light = CraigArm {
        m2: 1e-8,
        ..CRAIG_ARM
    };
    let m = light.mass_matrix(&Vector2::zeros());
    assert!(m[(1, 1)] < 1e-9 * m[(0, 0)]);
    let refusal = SingularMassMatrix::new(1, 0.0);
    let error = |m| refused("forward_dynamics", m, &refusal).error;
    assert_eq!(error(&m), Some(f64::INFINITY));
    let vanishing = Matrix2::new(4e-33, 0.0, 0.0, 0.7);
    assert_eq!(error(&vanishing), None);
}

#[test]
fn columns_that_are_missing_or_too_many_fail() {
    let report = check(|_, e| e.coriolis_coefficients = Some(Vec::new()));
    assert_eq!(wrong(&report), ["coriolis_coefficients"]);
    let report = check(|state, e| {
        e.coriolis_coefficients = Some(vec![coefficients(state).0; 2]);
    });
    assert_eq!(wrong(&report), ["coriolis_coefficients"]);
}

#[test]
fn a_function_compared_at_one_state_is_compared() {
    let report = check(|state, e| {
        if state.q[0] > 0.0 {
            e.mass_matrix = None;
        }
    });
    assert!(report.not_compared.is_empty());
    assert!(!report.to_string().contains("not compared"));
}

#[test]
fn the_report_names_the_state_of_the_largest_error() {
    let report = check(|state, e| {
        if state.q[0] > 100.0 {
            e.gravity_vector.as_mut().unwrap()[1] += state.q[0];
        }
    });
    let function = report.functions.iter().find(|f| !f.is_ok()).unwrap();
    assert_eq!(
        (function.function, function.joint),
        ("gravity_vector", Some(1))
    );
    assert!(function.label.starts_with("large angles"));
    assert!(function.q[0] > 100.0);
}

#[test]
fn the_printed_report_is_a_table() {
    let report = check(|_, e| e.kinetic_energy = Some(-1.0));
    let text = report.to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[0].starts_with("comparison with recursive Newton-Euler at 40 states (seed 0)"));
    // The name of the state starts where its heading does.
    let column = lines[1].rfind("state").unwrap();
    let labels = [
        "zero", "pi/2", "-pi/2", "right", "large", "at rest", "random",
    ];
    for line in &lines[2..10] {
        assert!(
            labels.iter().any(|label| line[column..].starts_with(label)),
            "{text}"
        );
    }
    assert_eq!(
        lines.iter().filter(|line| line.contains("WRONG")).count(),
        1
    );
    assert!(text.contains("kinetic_energy: error") && text.contains("qdd = ["));
    // All states in the alternate form.
    assert_eq!(format!("{report:#}").matches("qdd = [").count(), 8);
}

#[test]
#[should_panic(expected = "WRONG")]
fn assertion_panics_with_the_report() {
    check(|_, e| e.kinetic_energy = Some(-1.0)).assert_ok();
}

#[test]
fn a_report_of_nothing_is_not_ok() {
    let report = check(|_, e| *e = Evaluation::default());
    assert!(!report.is_ok());
    assert!(report.to_string().contains("no function"));
}
