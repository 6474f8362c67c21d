//! Hamilton's equations against those of Lagrange.

use robot_dynamics::nalgebra::{DMatrix, DVector};

use super::any_robot::AnyRobot;
use super::samples::{Magnitude, TOLERANCE, assert_small, largest, states};

/// p' = dT/dq - G - K - F + tau with dT/dq = C' qd, where dM/dt - 2 C is skew.
pub(super) fn forces_on_momenta_are_those_of_the_coriolis_matrix(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let (q, qd, tau) = (&state.q, &state.qd, &state.qdd);
        let kinetic = robot.coriolis_matrix(q, qd).transpose() * qd;
        let own = robot.spring_vector(q) + robot.friction_vector(qd);
        let expected = kinetic - robot.gravity_vector(q) - own + tau;
        let magnitude = Magnitude::at(robot, &state).torque;
        let force = robot.force_on_momenta(&state, tau);
        assert_small(&(force - expected), magnitude, n);
    }
}

/// M^-1 (M qd) = qd.
pub(super) fn velocity_undoes_momentum(robot: &dyn AnyRobot) {
    for state in states(robot) {
        let found = robot.momentum_and_back(&state);
        let [momentum, qd] = found.expect("M is positive definite");
        let m = robot.mass_matrix(&state.q);
        assert_small(
            &(&m * &state.qd - momentum),
            largest(&m) * largest(&state.qd),
            m.ncols(),
        );
        let bound = TOLERANCE * m.ncols() as f64 * m.amax() * state.qd.amax();
        assert_within(&(qd - &state.qd), bound, &m);
    }
}

/// Asserts that errors are what M makes of forces of up to `bound`.
#[track_caller]
pub(super) fn assert_within(errors: &DVector<f64>, bound: f64, m: &DMatrix<f64>) {
    let inverse = m.clone().try_inverse().expect("M is positive definite");
    for (i, error) in errors.iter().enumerate() {
        let bound = bound * inverse.row(i).abs().sum();
        assert!(
            error.abs() <= bound,
            "joint {i}: {error:e}, beyond {bound:e}"
        );
    }
}
