//! Functions that are made of others.

use robot_dynamics::SizedState;
use robot_dynamics::check::Evaluation;
use robot_dynamics::nalgebra::{DMatrix, DVector, Dyn};

use super::any_robot::AnyRobot;
use super::place::State;
use super::samples::{largest, states};

/// All functions of a robot at one state, by their names.
struct Values {
    found: Evaluation,
    n: usize,
    tip: String,
}

impl Values {
    fn at(robot: &dyn AnyRobot, state: &State) -> Self {
        let found = robot.evaluate(state, &state.qdd);
        let (n, tip) = (robot.freedoms(), robot.tip().to_owned());
        Values { found, n, tip }
    }

    fn numbers(&self, function: &str) -> DVector<f64> {
        let numbers: Option<Vec<f64>> = self.found.get(function);
        DVector::from(numbers.unwrap_or_else(|| panic!("{function} was asked for")))
    }

    fn of_tip(&self, function: &str) -> DVector<f64> {
        self.numbers(&format!("{function}{}", self.tip))
    }

    /// With a column for each degree of freedom, the first ones alone of a function that has more.
    fn matrix(&self, numbers: DVector<f64>, rows: usize) -> DMatrix<f64> {
        DMatrix::from_column_slice(rows, self.n, &numbers.as_slice()[..rows * self.n])
    }
}

/// Equal but for rounding.
#[track_caller]
fn same(found: DVector<f64>, expected: DVector<f64>) {
    let bound = 1e-11 * largest(&expected);
    let error = largest(&(&found - &expected));
    assert!(
        error <= bound,
        "{error:e}, beyond {bound:e}: {found} {expected}"
    );
}

/// M a_r + C v_r + G + K + F, by itself and by the base parameters.
pub(super) fn the_passivity_torque_is_that_of_references(robot: &dyn AnyRobot) {
    for state in states(robot) {
        let values = Values::at(robot, &state);
        let of = |function: &str| values.numbers(function);
        let moved = SizedState::<Dyn> {
            q: state.q.q.clone(),
            qd: state.qd.clone(),
            qdd: state.qdd.clone(),
        };
        let own = of("spring_vector") + of("friction_vector");
        let inertial = robot.mass_matrix(&state.q) * moved.reference_acceleration();
        let turning = robot.coriolis_matrix(&state.q, &state.qd) * moved.reference_velocity();
        let expected = inertial + turning + of("gravity_vector") + &own;
        same(of("passivity_torque"), expected.clone());
        same(of("passivity_form") + own, expected);
    }
}

/// T by the base parameters.
pub(super) fn the_kinetic_energy_is_that_of_the_parameters(robot: &dyn AnyRobot) {
    for state in states(robot) {
        let values = Values::at(robot, &state);
        let energies = values.numbers("energies_form");
        let kinetic = values.numbers("kinetic_energy");
        same(energies.rows(0, 1).into_owned(), kinetic);
    }
}

/// J v, and J a + dJ/dt v.
pub(super) fn the_tip_moves_by_its_jacobian(robot: &dyn AnyRobot) {
    for state in states(robot) {
        let values = Values::at(robot, &state);
        let [jacobian, rate] = ["jacobian", "jacobian_rate"].map(|function| {
            let numbers = values.of_tip(function);
            values.matrix(numbers, 6)
        });
        let State { qd, qdd, .. } = &state;
        same(values.of_tip("tool_velocity"), &jacobian * qd);
        let expected = &jacobian * qdd + rate * qd;
        same(values.of_tip("tool_acceleration"), expected);
    }
}

/// J' w, and J M^-1 J'.
pub(super) fn the_tip_is_pushed_by_its_jacobian(robot: &dyn AnyRobot) {
    for state in states(robot) {
        let values = Values::at(robot, &state);
        let jacobian = values.matrix(values.of_tip("jacobian"), 6);
        let wrench = SizedState::<Dyn>::wrench();
        let wrench = DVector::from_column_slice(wrench.as_slice());
        let outwards = jacobian.transpose();
        same(values.of_tip("wrench_torques"), &outwards * wrench);
        let found = robot.forward_dynamics_derivatives(&state.q, &state.qd, &state.qdd);
        let [.., inverse] = found.expect("M is positive definite");
        let expected = jacobian * inverse * outwards;
        let expected = DVector::from_column_slice(expected.as_slice());
        let found = values.of_tip("operational_inertia_inverse");
        same(found.rows(0, 36).into_owned(), expected);
    }
}
