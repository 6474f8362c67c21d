//! Derivatives of inverse and forward dynamics.

use num_dual::Dual64;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{AccelerationDerivatives, DoubleDouble, State};

use super::any_arm::AnyArm;
use super::gradient::unit;
use super::samples::{Magnitude, along, assert_small, largest, states};

/// The matrix whose column k is what `column` says of joint k.
fn by_columns<const N: usize>(column: impl Fn(usize) -> SVector<f64, N>) -> SMatrix<f64, N, N> {
    SMatrix::from_columns(&std::array::from_fn::<_, N, _>(column))
}

fn slope<const N: usize>(x: SVector<Dual64, N>) -> SVector<f64, N> {
    x.map(|x| x.eps)
}

fn still<const N: usize>(x: &SVector<f64, N>) -> SVector<Dual64, N> {
    along(x, &SVector::zeros())
}

/// Column k of d tau/dq is the derivative of tau along joint k, that of d tau/dqd along its velocity.
pub(super) fn force_derivatives_are_those_of_dual_numbers<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let State { q, qd, qdd } = &state;
        let (by_position, by_velocity) = robot.inverse_dynamics_derivatives(q, qd, qdd);
        let magnitude = Magnitude::at(robot, &state);
        let expected = by_columns(|k| {
            slope(robot.inverse_dynamics(&along(q, &unit(k)), &still(qd), &still(qdd)))
        });
        assert_small(&(by_position - expected), magnitude.force_by_position, N);
        let expected = by_columns(|k| {
            slope(robot.inverse_dynamics(&still(q), &along(qd, &unit(k)), &still(qdd)))
        });
        assert_small(&(by_velocity - expected), magnitude.force_by_velocity, N);
    }
}

/// Half the distance of the differences: its square, and 1e-31 over it, are below the roundings of
/// a double.
const STEP: f64 = 1.0 / (1u64 << 30) as f64;

/// (tau(x + h) - tau(x - h)) / 2 h, with 31 digits. Run with `--nocapture` to see the errors.
pub(super) fn force_derivatives_are_limits_of_differences<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    let mut worst = 0.0_f64;
    for state in states().take(4) {
        let State { q, qd, qdd } = &state;
        let (by_position, by_velocity) = robot.inverse_dynamics_derivatives(q, qd, qdd);
        let magnitude = Magnitude::at(robot, &state);
        let [q, qd, qdd] = [q, qd, qdd].map(|x| x.map(DoubleDouble::from));
        let difference = |tau: &dyn Fn(&SVector<DoubleDouble, N>) -> SVector<DoubleDouble, N>,
                          k| {
            let step: SVector<f64, N> = unit(k) * STEP;
            let step = step.map(DoubleDouble::from);
            let (before, after) = (tau(&step.map(|x| -x)), tau(&step));
            SVector::from_fn(|i, _| (after[i] - before[i]).high() / (2.0 * STEP))
        };
        let along_position = |step: &_| robot.inverse_dynamics(&(q + step), &qd, &qdd);
        let along_velocity = |step: &_| robot.inverse_dynamics(&q, &(qd + step), &qdd);
        let expected = by_columns(|k| difference(&along_position, k));
        let errors = [
            (by_position - expected, magnitude.force_by_position),
            (
                by_velocity - by_columns(|k| difference(&along_velocity, k)),
                magnitude.force_by_velocity,
            ),
        ];
        for (errors, magnitude) in &errors {
            assert_small(errors, *magnitude, N);
            worst = worst.max(largest(errors) / magnitude);
        }
    }
    println!("{}: {worst:.1e} of the natural magnitude", robot.file());
}

/// Errors of accelerations are judged by the forces that they need, M times the error. The
/// accelerations at which tau is differentiated carry roundings that M^-1 magnifies.
struct Residuals<const N: usize> {
    mass_matrix: SMatrix<f64, N, N>,
    magnitude: Magnitude,
    /// max |M| max |M^-1|
    condition: f64,
}

impl<const N: usize> Residuals<N> {
    fn at<const P: usize>(
        robot: &dyn AnyArm<N, P>,
        state: &State<N>,
        derivatives: &AccelerationDerivatives<f64, N>,
    ) -> Self {
        let magnitude = Magnitude::at(robot, state);
        let condition = magnitude.inertia * largest(&derivatives.2);
        Residuals {
            mass_matrix: robot.mass_matrix(&state.q),
            magnitude,
            condition,
        }
    }

    /// Asserts that the forces that are left are small beside those that act.
    #[track_caller]
    fn assert_small(
        &self,
        left: &AccelerationDerivatives<f64, N>,
        derivatives: &AccelerationDerivatives<f64, N>,
    ) {
        let Magnitude {
            inertia,
            torque,
            force_by_position,
            force_by_velocity,
            ..
        } = self.magnitude;
        let by_position = force_by_position + self.condition * torque;
        assert_small(&left.0, by_position + inertia * largest(&derivatives.0), N);
        assert_small(
            &left.1,
            force_by_velocity + inertia * largest(&derivatives.1),
            N,
        );
        assert_small(&left.2, 1.0 + inertia * largest(&derivatives.2), N);
    }
}

/// The derivatives are those of `forward_dynamics` on dual numbers.
pub(super) fn acceleration_derivatives_are_those_of_dual_numbers<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let State { q, qd, qdd } = &state;
        let tau = robot.inverse_dynamics(q, qd, qdd);
        let found = robot.forward_dynamics_derivatives(q, qd, &tau);
        let found = found.expect("M is positive definite");
        let expected = |q: SVector<Dual64, N>, qd: SVector<Dual64, N>, tau: SVector<Dual64, N>| {
            slope(
                robot
                    .forward_dynamics(&q, &qd, &tau)
                    .expect("M is positive definite"),
            )
        };
        let expected = (
            by_columns(|k| expected(along(q, &unit(k)), still(qd), still(&tau))),
            by_columns(|k| expected(still(q), along(qd, &unit(k)), still(&tau))),
            by_columns(|k| expected(still(q), still(qd), along(&tau, &unit(k)))),
        );
        let residuals = Residuals::at(robot, &state, &found);
        let m = residuals.mass_matrix;
        let left = (
            m * (found.0 - expected.0),
            m * (found.1 - expected.1),
            m * (found.2 - expected.2),
        );
        residuals.assert_small(&left, &found);
    }
}

/// M d qdd/dq = -d tau/dq and M d qdd/dqd = -d tau/dqd at that qdd, M d qdd/d tau = 1.
pub(super) fn acceleration_derivatives_satisfy_their_equations<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for mut state in states() {
        let tau = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        let qdd = robot.forward_dynamics(&state.q, &state.qd, &tau);
        state.qdd = qdd.expect("M is positive definite");
        let State { q, qd, qdd } = &state;
        let forces = robot.inverse_dynamics_derivatives(q, qd, qdd);
        let found = robot.forward_dynamics_derivatives(q, qd, &tau);
        let found = found.expect("M is positive definite");
        assert_eq!(found.2, found.2.transpose());
        let residuals = Residuals::at(robot, &state, &found);
        let m = residuals.mass_matrix;
        let left = (
            m * found.0 + forces.0,
            m * found.1 + forces.1,
            m * found.2 - SMatrix::identity(),
        );
        residuals.assert_small(&left, &found);
    }
}
