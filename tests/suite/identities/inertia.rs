//! The mass matrix.

use num_dual::Dual64;
use robot_dynamics::Row;
use robot_dynamics::nalgebra::{Matrix3, Matrix4, SMatrix, SVector, Vector3};

use super::gradient::unit;
use super::samples::{Magnitude, along, assert_small, states};
use robots::Arm;

/// Both triangles hold the same bits.
pub(super) fn mass_matrix_is_symmetric<const N: usize, const P: usize, R: Arm<N, P>>(robot: &R) {
    for state in states() {
        let m = robot.mass_matrix(&state.q);
        assert_eq!(m, m.transpose());
    }
}

/// x'Mx > 0 for every x, by its Cholesky factors.
pub(super) fn mass_matrix_is_positive_definite<const N: usize, const P: usize, R: Arm<N, P>>(
    robot: &R,
) {
    for state in states() {
        let mut pivots = robot.mass_matrix(&state.q);
        for k in 0..N {
            assert!(pivots[(k, k)] > 0.0, "pivot {k} is {}", pivots[(k, k)]);
            for i in k + 1..N {
                let factor = pivots[(i, k)] / pivots[(k, k)];
                for j in k + 1..N {
                    pivots[(i, j)] -= factor * pivots[(k, j)];
                }
            }
        }
    }
}

/// Velocity of the centre of mass and angular velocity in the link frame, of a link whose pose
/// carries its rate.
fn velocities(pose: &Matrix4<Dual64>, row: &Row) -> (Vector3<f64>, Vector3<f64>) {
    let rate = pose.map(|x| x.eps);
    let com = Vector3::from(row.com).push(1.0);
    let rotation = pose.map(|x| x.re).fixed_resize::<3, 3>(0.0);
    // R' dR/dt = [w x] with w in the link frame.
    let spin = rotation.transpose() * rate.fixed_resize::<3, 3>(0.0);
    let angular = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
    ((rate * com).xyz(), angular)
}

fn tensor(row: &Row) -> Matrix3<f64> {
    let [xx, yy, zz, xy, yz, xz] = row.inertia;
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
}

/// M_ij = sum over the links of m v_i.v_j + w_i.I w_j, with the reflected inertias on the
/// diagonal, where v_i and w_i are the link's velocities at unit speed of joint i: the kinetic
/// energy as every textbook defines it, from the poses alone.
pub(super) fn mass_matrix_is_that_of_the_moving_links<
    const N: usize,
    const P: usize,
    R: Arm<N, P>,
>(
    robot: &R,
) {
    let rows = robot.table().rows;
    for state in states() {
        let moving: [_; N] = std::array::from_fn(|j| robot.link_poses(&along(&state.q, &unit(j))));
        let mut expected = SMatrix::<f64, N, N>::zeros();
        for (link, row) in rows.iter().enumerate() {
            let velocities: Vec<_> = (moving.iter())
                .map(|poses| velocities(&poses[link], row))
                .collect();
            for (i, (v_i, w_i)) in velocities.iter().enumerate() {
                for (j, (v_j, w_j)) in velocities.iter().enumerate() {
                    expected[(i, j)] += row.mass * v_i.dot(v_j) + w_i.dot(&(tensor(row) * w_j));
                }
            }
            expected[(link, link)] += row.reflected_inertia();
        }
        let magnitude = Magnitude::at(robot, &state).inertia;
        assert_small(&(robot.mass_matrix(&state.q) - expected), magnitude, N);
    }
}

/// M e_j = tau(q, 0, e_j) - tau(q, 0, 0).
pub(super) fn columns_of_the_mass_matrix_are_torques_of_unit_accelerations<
    const N: usize,
    const P: usize,
    R: Arm<N, P>,
>(
    robot: &R,
) {
    let rest = SVector::zeros();
    for state in states() {
        let magnitude = Magnitude::at(robot, &state);
        let m = robot.mass_matrix(&state.q);
        let held = robot.inverse_dynamics(&state.q, &rest, &rest);
        for j in 0..N {
            let moved = robot.inverse_dynamics(&state.q, &rest, &unit(j));
            let difference = moved - held - m.column(j);
            assert_small(&difference, magnitude.inertia + magnitude.gravity, N);
        }
    }
}
