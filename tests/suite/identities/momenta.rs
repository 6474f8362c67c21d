//! Hamilton's equations against those of Lagrange.

use robot_dynamics::nalgebra::SVector;

use super::any_arm::AnyArm;
use super::samples::{Magnitude, TOLERANCE, assert_small, states};

/// p' = dT/dq - G - K - F + tau with dT/dq = C' qd, C of the Christoffel symbols.
pub(super) fn forces_on_momenta_are_those_of_the_coriolis_matrix<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    let arm = robot.momenta().expect("mass_matrix and inverse_dynamics");
    for state in states() {
        let (q, qd, tau) = (&state.q, &state.qd, &state.qdd);
        let kinetic = robot.coriolis_matrix(q, qd).transpose() * qd;
        let own = robot.spring_vector(q) + robot.friction_vector(qd);
        let expected = kinetic - robot.gravity_vector(q) - own + tau;
        let magnitude = Magnitude::at(robot, &state).torque;
        assert_small(&(arm.force(q, qd, tau) - expected), magnitude, N);
    }
}

/// M^-1 (M qd) = qd.
pub(super) fn velocity_undoes_momentum<const N: usize, const P: usize>(robot: &dyn AnyArm<N, P>) {
    let arm = robot.momenta().expect("mass_matrix and inverse_dynamics");
    for state in states() {
        let p: SVector<f64, N> = arm.momentum(&state.q, &state.qd);
        let qd = arm.velocity(&state.q, &p).expect("M is positive definite");
        let m = robot.mass_matrix(&state.q);
        let bound = TOLERANCE * N as f64 * m.amax() * state.qd.amax();
        let inverse = m.try_inverse().expect("M is positive definite");
        for (i, error) in (qd - state.qd).iter().enumerate() {
            let bound = bound * inverse.row(i).abs().sum();
            assert!(
                error.abs() <= bound,
                "joint {i}: {error:e}, beyond {bound:e}"
            );
        }
    }
}
