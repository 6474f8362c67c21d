//! Poses and the Jacobian.

use robot_dynamics::nalgebra::{Matrix3, Matrix4, RowVector4, Vector3};

use super::any_robot::AnyRobot;
use super::axes::{axes, placed, poses, with_followers};
use super::gradient::unit;
use super::place::Along;
use super::samples::{Magnitude, assert_small, states};

fn rotation(pose: &Matrix4<f64>) -> Matrix3<f64> {
    pose.fixed_view::<3, 3>(0, 0).into_owned()
}

fn position(pose: &Matrix4<f64>) -> Vector3<f64> {
    pose.fixed_view::<3, 1>(0, 3).into_owned()
}

pub(super) fn link_poses_are_products_of_the_transforms_of_the_table(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    let table = robot.table();
    for state in states(robot) {
        let reach = Magnitude::at(robot, &state).reach;
        let links = robot.link_poses(&state.q);
        let expected = axes(&table).into_iter().zip(poses(&table, &state.q.q));
        for (axis, expected) in expected.filter(|(axis, _)| axis.is_free) {
            let pose = links[axis.joint];
            assert_small(&rotation(&(pose - expected)), 1.0, n);
            assert_small(&position(&(pose - expected)), reach, n);
        }
    }
}

/// But for the tool.
pub(super) fn last_link_pose_is_the_forward_kinematics(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    let table = robot.table();
    let tool = placed(&table.tool.frame);
    for state in states(robot) {
        let links = with_followers(&table, &state.q.q, &robot.link_poses(&state.q));
        let expected = links.last().expect("a link") * tool;
        let difference = robot.forward_kinematics(&state.q) - expected;
        assert_small(&rotation(&difference), 1.0, n);
        let reach = Magnitude::at(robot, &state).reach;
        assert_small(&position(&difference), reach, n);
    }
}

/// R'R = 1 and det R = 1 for every link, above a last row of 0, 0, 0, 1.
pub(super) fn rotations_are_orthonormal(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        for pose in robot.link_poses(&state.q) {
            let r = rotation(&pose);
            assert_small(&(r.transpose() * r - Matrix3::identity()), 1.0, n);
            assert!(r.determinant() > 0.0);
            assert_eq!(pose.row(3), RowVector4::new(0.0, 0.0, 0.0, 1.0));
        }
    }
}

/// Column j of the Jacobian is the velocity of the tip's origin above its angular
/// velocity, where joint j moves at unit speed: dp/dq_j, and the w of dR/dq_j R' = [w x].
pub(super) fn jacobian_is_the_derivative_of_the_pose(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let jacobian = robot.jacobian(&state.q);
        let reach = Magnitude::at(robot, &state).reach;
        let pose = robot.forward_kinematics(&state.q);
        for j in 0..n {
            let moving = robot.forward_kinematics(&state.q.along(&unit(n, j)));
            let rate = moving.map(|x| x.eps);
            let linear = jacobian.fixed_view::<3, 1>(0, j) - position(&rate);
            assert_small(&linear, reach.max(1.0), n);

            let spin = rotation(&rate) * rotation(&pose).transpose();
            let angular = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
            assert_small(&(jacobian.fixed_view::<3, 1>(3, j) - angular), 1.0, n);
        }
    }
}
