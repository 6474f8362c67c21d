//! The mass matrix.

use num_dual::Dual64;
use robot_dynamics::nalgebra::{DMatrix, DVector, Matrix3, Matrix4, Vector3};

use super::any_robot::AnyRobot;
use super::axes::{axes, with_followers};
use super::gradient::unit;
use super::place::Along;
use super::samples::{Magnitude, assert_small, states};

/// Both triangles hold the same bits.
pub(super) fn mass_matrix_is_symmetric(robot: &dyn AnyRobot) {
    for state in states(robot) {
        let m = robot.mass_matrix(&state.q);
        assert_eq!(m, m.transpose());
    }
}

/// x'Mx > 0 for every x, by its Cholesky factors.
pub(super) fn mass_matrix_is_positive_definite(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let mut pivots = robot.mass_matrix(&state.q);
        for k in 0..n {
            assert!(pivots[(k, k)] > 0.0, "pivot {k} is {}", pivots[(k, k)]);
            for i in k + 1..n {
                let factor = pivots[(i, k)] / pivots[(k, k)];
                for j in k + 1..n {
                    pivots[(i, j)] -= factor * pivots[(k, j)];
                }
            }
        }
    }
}

/// Velocity of the centre of mass and angular velocity in its frame, of a body whose frame's pose
/// carries its rate.
fn velocities(pose: &Matrix4<Dual64>, com: [f64; 3]) -> (Vector3<f64>, Vector3<f64>) {
    let rate = pose.map(|x| x.eps);
    let com = Vector3::from(com).push(1.0);
    let rotation = pose.map(|x| x.re).fixed_resize::<3, 3>(0.0);
    // R' dR/dt = [w x] with w in the body's frame.
    let spin = rotation.transpose() * rate.fixed_resize::<3, 3>(0.0);
    let angular = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
    ((rate * com).xyz(), angular)
}

fn tensor([xx, yy, zz, xy, yz, xz]: [f64; 6]) -> Matrix3<f64> {
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
}

/// M_ij = sum over the bodies of m v_i.v_j + w_i.I w_j, with the reflected inertias on the diagonal. v_i and w_i are
/// the body's velocities at unit speed of joint i: the kinetic energy as every textbook defines it, from the poses
/// alone. The tool is the last body.
pub(super) fn mass_matrix_is_that_of_the_moving_links(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    let table = robot.table();
    let (axes, tool) = (axes(&table), table.tool);
    let links = axes.iter().map(|axis| axis.row);
    let links = links.map(|row| (row.mass, row.com, row.inertia));
    let bodies: Vec<_> = links.chain([(tool.mass, tool.com, tool.inertia)]).collect();
    for state in states(robot) {
        let at_unit_speed = |j| {
            let q = state.q.along(&unit(n, j));
            let links = with_followers(&table, &q.q, &robot.link_poses(&q));
            links
                .into_iter()
                .chain([robot.forward_kinematics(&q)])
                .collect::<Vec<_>>()
        };
        let moving: Vec<_> = (0..n).map(at_unit_speed).collect();
        let mut reflected = DVector::zeros(n);
        for axis in &axes {
            reflected[axis.joint] += axis.factor * axis.factor * axis.row.reflected_inertia();
        }
        let mut expected = DMatrix::from_diagonal(&reflected);
        for (body, (mass, com, inertia)) in bodies.iter().enumerate() {
            let velocities: Vec<_> = (moving.iter())
                .map(|poses| velocities(&poses[body], *com))
                .collect();
            for (i, (v_i, w_i)) in velocities.iter().enumerate() {
                for (j, (v_j, w_j)) in velocities.iter().enumerate() {
                    expected[(i, j)] += mass * v_i.dot(v_j) + w_i.dot(&(tensor(*inertia) * w_j));
                }
            }
        }
        let magnitude = Magnitude::at(robot, &state).inertia;
        assert_small(&(robot.mass_matrix(&state.q) - expected), magnitude, n);
    }
}

/// M e_j = tau(q, 0, e_j) - tau(q, 0, 0).
pub(super) fn columns_of_the_mass_matrix_are_torques_of_unit_accelerations(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    let rest = DVector::zeros(n);
    for state in states(robot) {
        let magnitude = Magnitude::at(robot, &state);
        let m = robot.mass_matrix(&state.q);
        let held = robot.inverse_dynamics(&state.q, &rest, &rest);
        for j in 0..n {
            let moved = robot.inverse_dynamics(&state.q, &rest, &unit(n, j));
            let difference = moved - &held - m.column(j);
            assert_small(&difference, magnitude.inertia + magnitude.gravity, n);
        }
    }
}
