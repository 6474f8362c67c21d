//! The same programs on `f32`.

use robot_dynamics::nalgebra::{DVector, Dim, Matrix, RawStorage, Vector1};

use super::any_robot::AnyRobot;
use super::place::State;
use super::samples::{Magnitude, assert_small, states};

/// The precision of `f64` over that of `f32`.
const COARSER: f64 = (1u64 << 29) as f64;

/// A state that `f32` holds exactly, so that only the computation differs.
fn rounded(state: &State) -> State {
    let round = |x: f64| f64::from(x as f32);
    State {
        q: state.q.map(round),
        qd: state.qd.map(round),
        qdd: state.qdd.map(round),
    }
}

fn single(v: &DVector<f64>) -> DVector<f32> {
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

pub(super) fn single_precision_agrees_with_double_precision(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let state = rounded(&state);
        let State { q, qd, qdd } = &state;
        let q32 = q.map(|x| x as f32);
        let (qd32, qdd32) = (single(qd), single(qdd));
        let is = Magnitude::at(robot, &state);
        let near = |x: DVector<f32>, exact: DVector<f64>, magnitude| {
            assert_near(&x, &exact, magnitude, n);
        };

        assert_near(
            &robot.mass_matrix(&q32),
            &robot.mass_matrix(q),
            is.inertia,
            n,
        );
        near(
            robot.coriolis_vector(&q32, &qd32),
            robot.coriolis_vector(q, qd),
            is.coriolis,
        );
        near(
            robot.gravity_vector(&q32),
            robot.gravity_vector(q),
            is.gravity,
        );
        near(
            robot.friction_vector(&qd32),
            robot.friction_vector(qd),
            is.torque,
        );
        near(robot.spring_vector(&q32), robot.spring_vector(q), is.spring);
        let torque = robot.inverse_dynamics(q, qd, qdd);
        near(
            robot.inverse_dynamics(&q32, &qd32, &qdd32),
            torque.clone(),
            is.torque,
        );
        let [by_position, by_velocity] = robot.inverse_dynamics_derivatives(q, qd, qdd);
        let [by_position32, by_velocity32] =
            robot.inverse_dynamics_derivatives(&q32, &qd32, &qdd32);
        assert_near(&by_position32, &by_position, is.force_by_position, n);
        assert_near(&by_velocity32, &by_velocity, is.force_by_velocity, n);
        assert_near(
            &robot.forward_kinematics(&q32),
            &robot.forward_kinematics(q),
            is.reach.max(1.0),
            n,
        );

        let found = robot.forward_dynamics(&q32, &qd32, &single(&torque));
        let found = found.expect("M is positive definite").map(f64::from);
        let needed = robot.inverse_dynamics(q, qd, &found);
        assert_near(&single(&torque), &needed, is.torque, n);
    }
}
