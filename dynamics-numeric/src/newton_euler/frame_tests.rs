//! Base and tool beside tables that say the same without them.

use approx::assert_abs_diff_eq;
use dynamics_runtime::{Convention, Frame, JointType, Placement, Row, State, Table, Tool};
use nalgebra::{Matrix4, Rotation3, SMatrix, SVector, Vector3};
use tables::{general_table, mounted_table, random_state};

use super::NewtonEuler;

const CONVENTIONS: [Convention; 2] = [Convention::Standard, Convention::Modified];

#[track_caller]
fn assert_near<const R: usize, const C: usize>(
    computed: SMatrix<f64, R, C>,
    expected: SMatrix<f64, R, C>,
) {
    let tolerance = 2e-13 * (1.0 + expected.amax());
    assert_abs_diff_eq!(computed, expected, epsilon = tolerance);
}

/// `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)` by nalgebra.
fn homogeneous(frame: &Frame) -> Matrix4<f64> {
    let [roll, pitch, yaw] = frame.rpy;
    let rotation = Rotation3::from_euler_angles(roll, pitch, yaw);
    Matrix4::new_translation(&Vector3::from(frame.xyz)) * rotation.to_homogeneous()
}

/// On a turned base the joints feel gravity turned the other way, and see the world from there.
#[test]
fn a_turned_base_is_gravity_turned_the_other_way() {
    for convention in CONVENTIONS {
        for seed in 1..=10 {
            let mounted = mounted_table::<5>(convention, seed);
            let base = homogeneous(&mounted.base);
            let rotation = base.fixed_view::<3, 3>(0, 0).into_owned();
            let gravity = rotation.transpose() * Vector3::from(mounted.gravity);
            let plain = Table {
                base: Frame::IDENTITY,
                gravity: gravity.into(),
                ..mounted.clone()
            };
            let (arm, plain) = (NewtonEuler::new(&mounted), NewtonEuler::new(&plain));
            let State { q, qd, qdd } = random_state::<5>(seed);
            assert_near(
                arm.inverse_dynamics(&q, &qd, &qdd),
                plain.inverse_dynamics(&q, &qd, &qdd),
            );
            assert_near(arm.gravity_vector(&q), plain.gravity_vector(&q));
            let tau = SVector::from_fn(|i, _| i as f64 - 2.0);
            assert_near(
                arm.forward_dynamics_aba(&q, &qd, &tau).unwrap(),
                plain.forward_dynamics(&q, &qd, &tau).unwrap(),
            );
            assert_near(
                arm.forward_kinematics(&q),
                base * plain.forward_kinematics(&q),
            );
            for (pose, plain) in arm.link_poses(&q).iter().zip(plain.link_poses(&q)) {
                assert_near(*pose, base * plain);
            }
            let mut turned = SMatrix::<f64, 6, 5>::zeros();
            for (k, j) in [(0, 0), (3, 0)] {
                let half = plain.jacobian(&q).fixed_view::<3, 5>(k, j).into_owned();
                turned
                    .fixed_view_mut::<3, 5>(k, j)
                    .copy_from(&(rotation * half));
            }
            assert_near(arm.jacobian(&q), turned);
            // -m g.p more at every position.
            let weight = mounted.total_mass() * Vector3::from(mounted.gravity);
            let more = -weight.dot(&Vector3::from(mounted.base.xyz));
            let difference = arm.potential_energy(&q) - plain.potential_energy(&q);
            assert_abs_diff_eq!(difference, more, epsilon = 1e-11);
        }
    }
}

/// A tool that is turned about z and displaced along z and x is a link behind a joint that is locked.
#[test]
fn a_tool_is_a_link_that_is_locked() {
    for seed in 1..=10 {
        let plain = general_table::<4>(Convention::Modified, seed);
        let tool = mounted_table::<4>(Convention::Modified, seed).tool;
        let (x, z, yaw) = (tool.frame.xyz[0], tool.frame.xyz[2], tool.frame.rpy[2]);
        let tool = Tool {
            frame: Frame {
                xyz: [x, 0.0, z],
                rpy: [0.0, 0.0, yaw],
            },
            ..tool
        };
        let link = Row {
            a: x,
            d: z,
            theta: yaw,
            mass: tool.mass,
            com: tool.com,
            inertia: tool.inertia,
            ..Row::new(JointType::Revolute)
        };
        let [one, two, three, four] = plain.rows;
        let locked = Table::<4>::lock(
            plain.convention,
            plain.gravity,
            [one, two, three, four, link],
            [None, None, None, None, Some(0.0)],
        );
        let arm = NewtonEuler::new(&Table { tool, ..plain });
        agree(&arm, &NewtonEuler::new(&locked), seed);
    }
}

/// Where the last joint is locked, the tool hangs on its link all the same.
#[test]
fn a_tool_behind_locked_joints() {
    for convention in CONVENTIONS {
        for seed in 1..=10 {
            let whole = mounted_table::<5>(convention, seed);
            let positions = [None, None, None, None, Some(0.7)];
            let locked = Table::<4> {
                base: whole.base,
                tool: whole.tool,
                ..Table::lock(convention, whole.gravity, whole.rows, positions)
            };
            let (whole, locked) = (NewtonEuler::new(&whole), NewtonEuler::new(&locked));
            let State { q, qd, qdd } = random_state::<4>(seed);
            let still = |x: &SVector<f64, 4>, last| x.push(last);
            let (q5, qd5, qdd5) = (still(&q, 0.7), still(&qd, 0.0), still(&qdd, 0.0));
            let tau = whole.inverse_dynamics(&q5, &qd5, &qdd5);
            let found = locked.inverse_dynamics(&q, &qd, &qdd);
            assert_near(found, tau.fixed_rows::<4>(0).into_owned());
            assert_near(locked.forward_kinematics(&q), whole.forward_kinematics(&q5));
        }
    }
}

/// Rows that say where they begin, and where link frame and tip are, as those of a URDF file.
#[test]
fn rows_that_begin_elsewhere_can_be_locked() {
    for (seed, row) in (1..=4).flat_map(|seed| [0, 2, 4].map(|row| (seed, row))) {
        let mut whole = mounted_table::<5>(Convention::Modified, seed);
        for (i, row) in (0..).zip(&mut whole.rows) {
            let other = mounted_table::<1>(Convention::Modified, 100 * seed + i);
            row.mount = Placement::of_frames(&[other.base]);
            row.link_frame = Placement::of_frames(&[other.tool.frame]);
        }
        whole.rows[4].tip = Some(Placement::of_frames(&[whole.base]));
        let mut positions = [None; 5];
        positions[row] = Some(0.7);
        let locked = Table::<4> {
            base: whole.base,
            tool: whole.tool,
            ..Table::lock(whole.convention, whole.gravity, whole.rows, positions)
        };
        let (whole, locked) = (NewtonEuler::new(&whole), NewtonEuler::new(&locked));
        let State { q, qd, qdd } = random_state::<4>(seed);
        let still = |x: &SVector<f64, 4>, at| x.insert_row(row, at);
        let (q5, qd5, qdd5) = (still(&q, 0.7), still(&qd, 0.0), still(&qdd, 0.0));
        let tau = whole.inverse_dynamics(&q5, &qd5, &qdd5).remove_row(row);
        assert_near(locked.inverse_dynamics(&q, &qd, &qdd), tau);
        assert_near(locked.forward_kinematics(&q), whole.forward_kinematics(&q5));
    }
}

/// Every function of both arms.
fn agree(arm: &NewtonEuler<4>, other: &NewtonEuler<4>, seed: u64) {
    let State { q, qd, qdd } = random_state::<4>(seed);
    assert_near(arm.mass_matrix(&q), other.mass_matrix(&q));
    assert_near(
        arm.inverse_dynamics(&q, &qd, &qdd),
        other.inverse_dynamics(&q, &qd, &qdd),
    );
    assert_near(arm.gravity_vector(&q), other.gravity_vector(&q));
    assert_near(arm.forward_kinematics(&q), other.forward_kinematics(&q));
    assert_near(arm.jacobian(&q), other.jacobian(&q));
    let energies = |arm: &NewtonEuler<4>| [arm.kinetic_energy(&q, &qd), arm.potential_energy(&q)];
    assert_near(SVector::from(energies(arm)), SVector::from(energies(other)));
}

/// Right angles are right: roll, then pitch, then yaw, about the axes of the outer frame.
#[test]
fn right_angles_of_a_base_are_exact() {
    use core::f64::consts::{FRAC_PI_2, PI};
    let row = Row::new(JointType::Revolute);
    let base = Frame {
        xyz: [1.0, 2.0, 3.0],
        rpy: [FRAC_PI_2, -FRAC_PI_2, PI],
    };
    let table = Table {
        base,
        ..Table::new(Convention::Modified, [0.0, 0.0, -9.81], [row])
    };
    let pose = NewtonEuler::new(&table).forward_kinematics(&SVector::zeros());
    #[rustfmt::skip]
    let expected = Matrix4::new(
        0.0, 1.0, 0.0, 1.0,
        0.0, 0.0, 1.0, 2.0,
        1.0, 0.0, 0.0, 3.0,
        0.0, 0.0, 0.0, 1.0,
    );
    assert_eq!(pose, expected);
}
