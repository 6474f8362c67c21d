//! The check of robots whose base moves passes what is right and finds what is wrong.

use dynamics_runtime::{Convention, FloatingState, Model, RuntimeTable, SizedState, Table};
use nalgebra::{DVector, SVector};
use tables::{floating_table, random_pose, random_state};

use super::at::At;
use super::functions::{Row, Rule};
use crate::check::{Check, Evaluation, FloatingEvaluate, Report};
use crate::{FloatingNewtonEuler, NumericArm, check_against_rnea};

type Robot = FloatingNewtonEuler<5, 11>;

/// A robot that evaluates all functions by Newton-Euler, with this added to the fifth number of its bias force.
struct Damaged(f64);

const RIGHT: Damaged = Damaged(0.0);

impl Model<5, 11> for Damaged {
    const JOINT_NAMES: [&'static str; 5] = ["a", "b", "c", "d", "e"];

    fn table(&self) -> Table<5> {
        floating_table(Convention::Modified, 2)
    }
}

impl FloatingEvaluate<5, 11> for Damaged {
    fn evaluate(&self, state: &FloatingState<5, 11>, tau: &SVector<f64, 11>) -> Evaluation {
        let mut values = complete(&Robot::new(&self.table()), state, tau);
        let mut bias = Robot::new(&self.table()).bias_force(&state.base, &state.q, &state.v);
        bias[4] += self.0;
        values.set("bias_force", bias);
        values
    }

    fn evaluate_parts(
        &self,
        state: &FloatingState<5, 11>,
        _: &SVector<f64, 11>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        let robot = Robot::new(&self.table());
        let mut parts = Evaluation::default();
        parts.set("mass_matrix", robot.mass_matrix(&state.q));
        found("both", parts);
    }
}

/// All functions, those of the tip at the frame of row 1.
fn complete(robot: &Robot, state: &FloatingState<5, 11>, tau: &SVector<f64, 11>) -> Evaluation {
    let FloatingState { base, q, v, a } = state;
    let motion = state.motion();
    let mut e = Evaluation::default();
    let mass_matrix = robot.mass_matrix(q);
    let inverse = mass_matrix.try_inverse().expect("regular");
    let qdd = robot.forward_dynamics(base, q, v, tau);
    let joint_forces = robot.spring_vector(q) + robot.friction_vector(v);
    let passivity = mass_matrix * motion.reference_acceleration()
        + robot.coriolis_matrix(q, v) * motion.reference_velocity()
        + robot.gravity_vector(base, q);
    let (by_position, by_velocity) = robot.inverse_dynamics_derivatives(base, q, v, a);
    let (jerk, snap) = (motion.jerk(), motion.snap());
    let rates = robot.inverse_dynamics_rates(base, q, v, a, &jerk, &snap);
    let second = robot.inverse_dynamics_second_derivatives(base, q, v, a);
    e.set("mass_matrix", mass_matrix);
    e.set("coriolis_vector", robot.coriolis_vector(q, v));
    e.set("gravity_vector", robot.gravity_vector(base, q));
    e.set("friction_vector", robot.friction_vector(v));
    e.set("spring_vector", robot.spring_vector(q));
    e.set("inverse_dynamics", robot.inverse_dynamics(base, q, v, a));
    e.set("forward_dynamics", qdd);
    e.set(
        "forward_dynamics_aba",
        robot.forward_dynamics_aba(base, q, v, tau),
    );
    e.set("kinetic_energy", robot.kinetic_energy(q, v));
    e.set("potential_energy", robot.potential_energy(base, q));
    e.set("bias_force", robot.bias_force(base, q, v));
    e.set("coriolis_matrix", robot.coriolis_matrix(q, v));
    e.set("link_poses", robot.link_poses(base, q));
    e.set("link_jacobians", robot.link_jacobians(base, q));
    e.set("center_of_mass", robot.center_of_mass(base, q));
    e.set(
        "center_of_mass_jacobian",
        robot.center_of_mass_jacobian(base, q),
    );
    e.set(
        "centroidal_momentum_matrix",
        robot.centroidal_momentum_matrix(base, q),
    );
    e.set(
        "centroidal_momentum_bias",
        robot.centroidal_momentum_bias(base, q, v),
    );
    e.set("generalized_momentum", robot.generalized_momentum(q, v));
    e.set("momentum_bias", robot.momentum_bias(base, q, v));
    e.set("passivity_torque", passivity + joint_forces);
    e.set("inverse_dynamics_derivatives", (by_position, by_velocity));
    e.set(
        "forward_dynamics_derivatives",
        (-inverse * by_position, -inverse * by_velocity, inverse),
    );
    e.set("inverse_dynamics_rates", rates);
    e.set("inverse_dynamics_second_derivatives", second);
    let jacobian = robot.frame_jacobian(1, base, q);
    let rate = robot.frame_jacobian_rate(1, base, q, v);
    let wrench = SizedState::<nalgebra::Const<11>>::wrench();
    let at_frame = e.at_frame("foot", 1);
    at_frame.set("forward_kinematics", robot.frame_pose(1, base, q));
    at_frame.set("jacobian", jacobian);
    at_frame.set("jacobian_rate", rate);
    at_frame.set(
        "wrench_torques",
        robot.frame_wrench_torques(1, base, q, &wrench),
    );
    at_frame.set("tool_velocity", jacobian * v);
    at_frame.set("tool_acceleration", jacobian * a + rate * v);
    let inverse = jacobian * inverse * jacobian.transpose();
    at_frame.set("operational_inertia_inverse", inverse);
    e
}

#[test]
fn a_right_robot_passes() {
    // The compiler finds out that the base moves.
    let _: fn(&Damaged) -> Report = |robot| check_against_rnea(robot);
    let report = Check::new().samples(5).certify(&RIGHT);
    report.assert_ok();
    // Each function above, and the part of a tuple.
    assert_eq!(report.functions.len(), 33);
    for function in &report.functions {
        assert!(function.error < 1e-13, "{function}");
        assert_eq!(function.states, report.states);
        assert!(function.base.is_some());
    }
}

/// A change of any number of any function is found, in this function and in no other.
#[test]
fn every_number_is_compared() {
    let (table, robot) = (RIGHT.table(), Robot::new(&RIGHT.table()));
    let motion = random_state::<11>(7);
    let state = FloatingState {
        base: random_pose(7),
        q: motion.q.fixed_rows::<5>(0).into_owned(),
        v: motion.qd,
        a: motion.qdd,
    };
    let tau = robot.inverse_dynamics(&state.base, &state.q, &state.v, &state.a);
    let values = complete(&robot, &state, &tau);
    let table = RuntimeTable::from(&table);
    let vector = |x: &[f64]| DVector::from_column_slice(x);
    let sized = SizedState {
        q: vector(state.q.as_slice()),
        qd: vector(state.v.as_slice()),
        qdd: vector(state.a.as_slice()),
    };
    let (numeric, forces) = (NumericArm::on_any_base(&table), vector(tau.as_slice()));
    let footing = numeric.footing(&state.base);
    let mut at = At::new(
        numeric.placed(&footing),
        &table,
        (&state.base, &sized),
        &forces,
    );
    let mut check = |values: &Evaluation, at_foot: bool, name: &str| {
        at.frame = at_foot.then_some(1);
        let row = Row::<f64>::ALL.iter().find(|row| row.name == name);
        let found = row.and_then(|row| row.deviation(values, &at));
        found.and_then(|found| found.error).expect(name)
    };
    for at_foot in [false, true] {
        let mut right = values.clone();
        if at_foot {
            right = right.at_frame("foot", 1).clone();
        }
        for row in Row::<f64>::ALL {
            let Some(entries) = right.get::<Vec<f64>>(row.name) else {
                continue;
            };
            assert!(check(&right, at_foot, row.name) < 1e-13, "{}", row.name);
            let largest = entries.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            // Some of the many second derivatives.
            for entry in (0..entries.len()).step_by(1 + entries.len() / 150) {
                let mut damaged = entries.clone();
                damaged[entry] += 1e-8 * (1.0 + largest);
                let mut values = right.clone();
                values.set(row.name, damaged);
                let error = check(&values, at_foot, row.name);
                assert!(error > 6e-13, "{} {entry}: {error:e}", row.name);
            }
        }
    }
}

/// Functions that no robot on a base that moves has, and forms of two functions.
#[test]
fn every_other_function_is_compared() {
    let report = Check::new().samples(1).run(&RIGHT);
    let compared: Vec<_> = report
        .functions
        .iter()
        .map(|found| found.function)
        .collect();
    let rows = Row::<f64>::ALL.iter();
    let rows = rows.filter(|row| !matches!(row.rule, Rule::FactorOf(..)));
    let without = rows
        .map(|row| row.name)
        .filter(|name| !compared.contains(name));
    assert_eq!(
        without.collect::<Vec<_>>(),
        [
            "coriolis_coefficients",
            "centrifugal_coefficients",
            "configuration_space_form",
            "regressor_form",
            "taylor_series",
            "passivity_form",
            "energies_form",
        ]
    );
}

/// The report says where the base stands, and names its numbers.
#[test]
fn a_report_shows_the_base() {
    let report = Check::new().samples(3).run(&Damaged(1e-6));
    let text = report.to_string();
    assert!(
        text.contains("base wy") && text.contains("base = ["),
        "{text}"
    );
    let found = report.functions.iter().find(|found| !found.is_ok());
    assert_eq!(found.expect("it is wrong").qd.len(), 11);
}
