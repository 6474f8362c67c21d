//! Derivatives of inverse and forward dynamics.

use num_dual::Dual64;
use robot_dynamics::DoubleDouble;
use robot_dynamics::nalgebra::{DMatrix, DVector};

use super::any_robot::AnyRobot;
use super::gradient::unit;
use super::place::{Along, Place, State};
use super::samples::{Magnitude, assert_small, largest, states};

/// The matrix whose column k is what `column` says of the unit vector of joint k.
fn by_columns(n: usize, column: impl Fn(&DVector<f64>) -> DVector<f64>) -> DMatrix<f64> {
    let columns: Vec<_> = (0..n).map(|k| column(&unit(n, k))).collect();
    DMatrix::from_columns(&columns)
}

fn slope(x: DVector<Dual64>) -> DVector<f64> {
    x.map(|x| x.eps)
}

/// Column k of d tau/dq is the derivative of tau along joint k, that of d tau/dqd along its velocity.
pub(super) fn force_derivatives_are_those_of_dual_numbers(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let State { q, qd, qdd } = &state;
        let [by_position, by_velocity] = robot.inverse_dynamics_derivatives(q, qd, qdd);
        let magnitude = Magnitude::at(robot, &state);
        let along_position = |k: &_| robot.inverse_dynamics(&q.along(k), &qd.still(), &qdd.still());
        let expected = by_columns(n, |k| slope(along_position(k)));
        assert_small(&(by_position - expected), magnitude.force_by_position, n);
        let along_velocity = |k: &_| robot.inverse_dynamics(&q.still(), &qd.along(k), &qdd.still());
        let expected = by_columns(n, |k| slope(along_velocity(k)));
        assert_small(&(by_velocity - expected), magnitude.force_by_velocity, n);
    }
}

/// Half the distance of the differences: its square, and 1e-31 over it, are below the roundings of
/// a double.
const STEP: f64 = 1.0 / (1u64 << 30) as f64;

/// (tau(x + h) - tau(x - h)) / 2 h, with 31 digits. Run with `--nocapture` to see the errors.
pub(super) fn force_derivatives_are_limits_of_differences(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    let mut worst = 0.0_f64;
    for state in states(robot).take(4) {
        let State { q, qd, qdd } = &state;
        let [by_position, by_velocity] = robot.inverse_dynamics_derivatives(q, qd, qdd);
        let magnitude = Magnitude::at(robot, &state);
        let [exact_qd, exact_qdd] = [qd, qdd].map(|x| x.map(DoubleDouble::from));
        let half = |tau: &dyn Fn(DVector<DoubleDouble>) -> DVector<DoubleDouble>,
                    k: &DVector<f64>| {
            let at = |step: f64| tau(k.map(|x| DoubleDouble::from(x * step)));
            (at(STEP) - at(-STEP)).map(|x| x.high() / (2.0 * STEP))
        };
        let along_position =
            |step| robot.inverse_dynamics(&q.displaced(&step), &exact_qd, &exact_qdd);
        let at: Place<DoubleDouble> = q.map(DoubleDouble::from);
        let along_velocity = |step| robot.inverse_dynamics(&at, &(&exact_qd + step), &exact_qdd);
        let errors = [
            (
                by_position - by_columns(n, |k| half(&along_position, k)),
                magnitude.force_by_position,
            ),
            (
                by_velocity - by_columns(n, |k| half(&along_velocity, k)),
                magnitude.force_by_velocity,
            ),
        ];
        for (errors, magnitude) in &errors {
            assert_small(errors, *magnitude, n);
            worst = worst.max(largest(errors) / magnitude);
        }
    }
    println!("{}: {worst:.1e} of the natural magnitude", robot.file());
}

/// Errors of accelerations are judged by the forces that they need, M times the error. The
/// accelerations at which tau is differentiated carry roundings that M^-1 magnifies.
struct Residuals {
    mass_matrix: DMatrix<f64>,
    magnitude: Magnitude,
    /// max |M| max |M^-1|
    condition: f64,
}

impl Residuals {
    fn at(robot: &dyn AnyRobot, state: &State, derivatives: &[DMatrix<f64>; 3]) -> Self {
        let magnitude = Magnitude::at(robot, state);
        let condition = magnitude.inertia * largest(&derivatives[2]);
        Residuals {
            mass_matrix: robot.mass_matrix(&state.q),
            magnitude,
            condition,
        }
    }

    /// Asserts that the forces that are left are small beside those that act.
    #[track_caller]
    fn assert_small(&self, left: &[DMatrix<f64>; 3], derivatives: &[DMatrix<f64>; 3]) {
        let is = &self.magnitude;
        let by_position = is.force_by_position + self.condition * is.torque;
        let sizes = [by_position, is.force_by_velocity, 1.0];
        for ((left, derivative), size) in left.iter().zip(derivatives).zip(sizes) {
            assert_small(left, size + is.inertia * largest(derivative), left.ncols());
        }
    }
}

/// The derivatives are those of `forward_dynamics` on dual numbers.
pub(super) fn acceleration_derivatives_are_those_of_dual_numbers(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let State { q, qd, qdd } = &state;
        let tau = robot.inverse_dynamics(q, qd, qdd);
        let found = robot.forward_dynamics_derivatives(q, qd, &tau);
        let found = found.expect("M is positive definite");
        let along = |q: &_, qd: &_, tau: &_| {
            slope(
                robot
                    .forward_dynamics(q, qd, tau)
                    .expect("M is positive definite"),
            )
        };
        let expected = [
            by_columns(n, |k| along(&q.along(k), &qd.still(), &tau.still())),
            by_columns(n, |k| along(&q.still(), &qd.along(k), &tau.still())),
            by_columns(n, |k| along(&q.still(), &qd.still(), &tau.along(k))),
        ];
        let residuals = Residuals::at(robot, &state, &found);
        let left = [0, 1, 2].map(|i| &residuals.mass_matrix * (&found[i] - &expected[i]));
        residuals.assert_small(&left, &found);
    }
}

/// M d qdd/dq = -d tau/dq and M d qdd/dqd = -d tau/dqd at that qdd, M d qdd/d tau = 1.
pub(super) fn acceleration_derivatives_satisfy_their_equations(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for mut state in states(robot) {
        let tau = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        let qdd = robot.forward_dynamics(&state.q, &state.qd, &tau);
        state.qdd = qdd.expect("M is positive definite");
        let State { q, qd, qdd } = &state;
        let forces = robot.inverse_dynamics_derivatives(q, qd, qdd);
        let found = robot.forward_dynamics_derivatives(q, qd, &tau);
        let found = found.expect("M is positive definite");
        assert_eq!(found[2], found[2].transpose());
        let residuals = Residuals::at(robot, &state, &found);
        let m = &residuals.mass_matrix;
        let left = [
            m * &found[0] + &forces[0],
            m * &found[1] + &forces[1],
            m * &found[2] - DMatrix::identity(n, n),
        ];
        residuals.assert_small(&left, &found);
    }
}
