//! The same programs on `f32`.

use robot_dynamics::State;
use robot_dynamics::nalgebra::{Dim, Matrix, RawStorage, SVector, Vector1};

use super::any_arm::AnyArm;
use super::samples::{Magnitude, assert_small, states};

/// The precision of `f64` over that of `f32`.
const COARSER: f64 = (1u64 << 29) as f64;

/// A state that `f32` holds exactly, so that only the computation differs.
fn rounded<const N: usize>(state: &State<N>) -> State<N> {
    let round = |v: &SVector<f64, N>| v.map(|x| f64::from(x as f32));
    State {
        q: round(&state.q),
        qd: round(&state.qd),
        qdd: round(&state.qdd),
    }
}

fn single<const N: usize>(v: &SVector<f64, N>) -> SVector<f32, N> {
    v.map(|x| x as f32)
}

#[track_caller]
fn assert_near<R: Dim, C: Dim, S, D>(
    single: &Matrix<f32, R, C, S>,
    double: &Matrix<f64, R, C, D>,
    magnitude: f64,
    joints: usize,
) where
    S: RawStorage<f32, R, C>,
    D: RawStorage<f64, R, C>,
{
    for (x, exact) in single.iter().zip(double.iter()) {
        let difference = Vector1::new(f64::from(*x) - exact);
        assert_small(&difference, COARSER * magnitude, joints);
    }
}

pub(super) fn single_precision_agrees_with_double_precision<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let state @ State { q, qd, qdd } = rounded(&state);
        let (q32, qd32, qdd32) = (single(&q), single(&qd), single(&qdd));
        let is = Magnitude::at(robot, &state);
        let near = |x: SVector<f32, N>, exact: SVector<f64, N>, magnitude| {
            assert_near(&x, &exact, magnitude, N);
        };

        assert_near(
            &robot.mass_matrix(&q32),
            &robot.mass_matrix(&q),
            is.inertia,
            N,
        );
        near(
            robot.coriolis_vector(&q32, &qd32),
            robot.coriolis_vector(&q, &qd),
            is.coriolis,
        );
        near(
            robot.gravity_vector(&q32),
            robot.gravity_vector(&q),
            is.gravity,
        );
        near(
            robot.friction_vector(&qd32),
            robot.friction_vector(&qd),
            is.torque,
        );
        near(
            robot.spring_vector(&q32),
            robot.spring_vector(&q),
            is.spring,
        );
        let torque = robot.inverse_dynamics(&q, &qd, &qdd);
        near(
            robot.inverse_dynamics(&q32, &qd32, &qdd32),
            torque,
            is.torque,
        );
        let (by_position, by_velocity) = robot.inverse_dynamics_derivatives(&q, &qd, &qdd);
        let (by_position32, by_velocity32) =
            robot.inverse_dynamics_derivatives(&q32, &qd32, &qdd32);
        assert_near(&by_position32, &by_position, is.force_by_position, N);
        assert_near(&by_velocity32, &by_velocity, is.force_by_velocity, N);
        assert_near(
            &robot.forward_kinematics(&q32),
            &robot.forward_kinematics(&q),
            is.reach.max(1.0),
            N,
        );

        let found = robot.forward_dynamics(&q32, &qd32, &single(&torque));
        let found = found.expect("M is positive definite").map(f64::from);
        let needed = robot.inverse_dynamics(&q, &qd, &found);
        assert_near(&single(&torque), &needed, is.torque, N);
    }
}
