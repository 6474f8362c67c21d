//! Trees beside arms that say the same: joints that are held, followers that move by themselves, tools.

use approx::assert_abs_diff_eq;
use dynamics_runtime::{
    Carrier, Convention, FixedFrame, JointMotion, Placement, Row, RuntimeTable, State, Table, Tool,
};
use nalgebra::{DVector, Dyn, SMatrix, SVector, Vector6};
use tables::{general_table, mounted_table, random_state};

use super::{NewtonEuler, NumericArm};

#[track_caller]
fn assert_near<const R: usize, const C: usize>(
    computed: SMatrix<f64, R, C>,
    expected: SMatrix<f64, R, C>,
) {
    let tolerance = 1e-12 * (1.0 + expected.amax());
    assert_abs_diff_eq!(computed, expected, epsilon = tolerance);
}

fn convention(seed: u64) -> Convention {
    [Convention::Standard, Convention::Modified][seed as usize % 2]
}

/// Branches on the base, on row 0 and on row 2, each row at a place of its own; a frame with a body on each row and on the
/// base.
fn tree(seed: u64) -> ([Row; 6], [FixedFrame; 7], Table<6>) {
    let table = mounted_table::<6>(convention(seed), seed);
    let on = [
        Carrier::Above,
        Carrier::Row(0),
        Carrier::Row(0),
        Carrier::Above,
        Carrier::Row(2),
        Carrier::Base,
    ];
    let others: [Table<6>; 6] =
        core::array::from_fn(|i| mounted_table(table.convention, 100 * seed + i as u64));
    let row = |i: usize| Row {
        on: on[i],
        mount: Placement::of_frames(&[others[i].base]),
        ..table.rows[i]
    };
    let frame = |i: usize| FixedFrame {
        mass: 0.3,
        com: others[i % 6].tool.com,
        inertia: [0.01, 0.02, 0.02, 0.001, 0.0, 0.002],
        ..FixedFrame::new(
            i.checked_sub(1),
            Placement::of_frames(&[others[i % 6].tool.frame]),
        )
    };
    let table = Table {
        tool: Tool::NONE,
        ..table
    };
    (
        core::array::from_fn(row),
        core::array::from_fn(frame),
        table,
    )
}

/// The positions of all rows are S q + c.
fn moving<const N: usize>(motions: &[JointMotion; 6]) -> (SMatrix<f64, 6, N>, SVector<f64, 6>) {
    let (mut s, mut c) = (SMatrix::zeros(), SVector::zeros());
    let free = |row: usize| {
        let above = motions[..row].iter();
        above.filter(|motion| **motion == JointMotion::Free).count()
    };
    for (row, motion) in motions.iter().enumerate() {
        match *motion {
            JointMotion::Free => s[(row, free(row))] = 1.0,
            JointMotion::Locked(position) => c[row] = position,
            JointMotion::Follows {
                leader,
                factor,
                offset,
            } => (s[(row, free(leader))], c[row]) = (factor, offset),
        }
    }
    (s, c)
}

fn follows(leader: usize, factor: f64, offset: f64) -> JointMotion {
    JointMotion::Follows {
        leader,
        factor,
        offset,
    }
}

/// By virtual work: with the positions S q + c, tau is S' of the torques of the tree in which each row moves.
#[test]
fn joints_of_trees_are_locked_and_follow_others() {
    use JointMotion::{Free, Locked};
    let all = [
        // A leader behind its follower on another branch, and one before.
        [
            Free,
            follows(4, -0.5, 0.3),
            Free,
            follows(0, 1.5, -0.2),
            Free,
            Locked(0.4),
        ],
        // Locked on the base, and where branches stand.
        [
            Locked(0.7),
            Free,
            Locked(-0.3),
            Free,
            Free,
            follows(1, -1.0, 0.0),
        ],
        [Free, Locked(0.2), Free, Locked(1.1), Locked(-0.6), Free],
    ];
    for (seed, motions) in (1..=6).flat_map(|seed| all.map(|motions| (seed, motions))) {
        let (rows, frames, whole) = tree(seed);
        let whole = Table {
            rows,
            frames: frames[..].into(),
            ..whole
        };
        let reduced = Table::<3> {
            base: whole.base,
            ..Table::with_frames(whole.convention, whole.gravity, rows, motions, frames)
        };
        assert_eq!(reduced.frames.len(), 7);
        let (s, c) = moving::<3>(&motions);
        let (arm, whole) = (NewtonEuler::new(&reduced), NewtonEuler::new(&whole));
        let State { q, qd, qdd } = random_state::<3>(seed);
        let (p, v, a) = (s * q + c, s * qd, s * qdd);
        // Springs and friction do nothing at locked joints, where their rows of S are zero.
        assert_near(
            arm.inverse_dynamics(&q, &qd, &qdd),
            s.tr_mul(&whole.inverse_dynamics(&p, &v, &a)),
        );
        // A motor of a locked joint has no column in S either.
        assert_near(arm.mass_matrix(&q), s.tr_mul(&(whole.mass_matrix(&p) * s)));
        let found = arm.inverse_dynamics_derivatives(&q, &qd, &qdd);
        let expected = whole.inverse_dynamics_derivatives(&p, &v, &a);
        assert_near(found.0, s.tr_mul(&(expected.0 * s)));
        assert_near(found.1, s.tr_mul(&(expected.1 * s)));
        let tau = arm.inverse_dynamics(&q, &qd, &qdd);
        for found in [
            arm.forward_dynamics(&q, &qd, &tau),
            arm.forward_dynamics_aba(&q, &qd, &tau),
        ] {
            assert_abs_diff_eq!(found.expect("regular"), qdd, epsilon = 1e-9);
        }
        let kinetic = whole.kinetic_energy(&p, &v);
        assert_abs_diff_eq!(
            arm.kinetic_energy(&q, &qd),
            kinetic,
            epsilon = 1e-11 * (1.0 + kinetic)
        );
        for frame in 0..7 {
            assert_near(arm.frame_pose(frame, &q), whole.frame_pose(frame, &p));
            assert_near(
                arm.frame_jacobian(frame, &q),
                whole.frame_jacobian(frame, &p) * s,
            );
            let wrench = Vector6::new(0.3, -0.7, 0.5, -0.2, 0.4, 0.9);
            let torques = whole.frame_jacobian(frame, &p).tr_mul(&wrench);
            assert_near(
                arm.frame_wrench_torques(frame, &q, &wrench),
                s.tr_mul(&torques),
            );
            assert_near(
                arm.frame_jacobian_rate(frame, &q, &qd),
                whole.frame_jacobian_rate(frame, &p, &v) * s,
            );
        }
        let free = (0..6).filter(|row| motions[*row] == Free);
        for (joint, row) in free.enumerate() {
            assert_near(arm.link_poses(&q)[joint], whole.link_poses(&p)[row]);
            assert_near(
                arm.link_jacobians(&q)[joint],
                whole.link_jacobians(&p)[row] * s,
            );
        }
        same_at_run_time(&arm, &reduced, &State { q, qd, qdd });
        let blocks = arm.standard_regressor(&q, &qd, &qdd);
        let links = blocks.iter().zip(reduced.standard_parameters());
        let followers = arm.standard_regressor_of_followers(&q, &qd, &qdd);
        let followers = followers.zip(reduced.standard_parameters_of_followers());
        let sum = links.fold(SVector::zeros(), |sum, (y, x)| sum + y * x)
            + followers.fold(SVector::<f64, 3>::zeros(), |sum, (y, x)| sum + y * x);
        let mut motors = SVector::<f64, 3>::zeros();
        arm.walk_outward(|place| {
            place.add(&mut motors, place.link.reflected_inertia * place.of(&qdd))
        });
        let other = motors + arm.friction_vector(&qd) + arm.spring_vector(&q);
        assert_near(sum + other, tau);
    }
}

/// The same numbers, whether the compiler knows how many joints there are.
fn same_at_run_time(arm: &NewtonEuler<3>, table: &Table<3>, state: &State<3>) {
    let sized = NumericArm::<Dyn>::new(&RuntimeTable::from(table));
    assert_eq!(RuntimeTable::from(table).of_joints().as_ref(), Some(table));
    let [q, qd, qdd] =
        [state.q, state.qd, state.qdd].map(|x| DVector::from_column_slice(x.as_slice()));
    let tau = arm.inverse_dynamics(&state.q, &state.qd, &state.qdd);
    assert_eq!(
        sized.inverse_dynamics(&q, &qd, &qdd).as_slice(),
        tau.as_slice()
    );
    let jacobian = arm.frame_jacobian(6, &state.q);
    assert_eq!(sized.frame_jacobian(6, &q).as_slice(), jacobian.as_slice());
}

/// Differences of the poses are the velocities that the Jacobian says, and its own differences its rate.
#[test]
fn jacobians_of_frames_are_the_slopes_of_their_poses() {
    for seed in 1..=4 {
        let (rows, frames, table) = tree(seed);
        let frames = frames[..].into();
        let arm = NewtonEuler::new(&Table {
            rows,
            frames,
            ..table
        });
        let State { q, qd, .. } = random_state::<6>(seed);
        let carriers = [0b0, 0b1, 0b11, 0b101, 0b1101, 0b10101, 0b100000];
        for (frame, carriers) in carriers.into_iter().enumerate() {
            let jacobian = arm.frame_jacobian(frame, &q);
            for joint in 0..6 {
                let is_carrier = carriers >> joint & 1 == 1;
                assert_eq!(
                    jacobian.column(joint).amax() > 0.0,
                    is_carrier,
                    "{frame} {joint}"
                );
            }
            let h = 1e-6;
            let [after, before] = [h, -h].map(|h| q + qd * h);
            let apart = arm.frame_pose(frame, &after) - arm.frame_pose(frame, &before);
            let velocity = jacobian * qd;
            let slope = apart.fixed_view::<3, 1>(0, 3) / (2.0 * h);
            assert_abs_diff_eq!(
                velocity.fixed_rows::<3>(0).into_owned(),
                slope,
                epsilon = 1e-8
            );
            let slope = (arm.frame_jacobian(frame, &after) - arm.frame_jacobian(frame, &before))
                / (2.0 * h);
            assert_abs_diff_eq!(
                arm.frame_jacobian_rate(frame, &q, &qd),
                slope,
                epsilon = 1e-7
            );
        }
        // Several rows carry no other.
        assert!(arm.forward_kinematics(&q).iter().all(|x| x.is_nan()));
        assert!(arm.jacobian(&q).iter().all(|x| x.is_nan()));
        assert!(arm.jacobian_rate(&q, &qd).iter().all(|x| x.is_nan()));
    }
}

/// A frame at the end of an arm, with the tool's body, is the tool. A body on the base counts nowhere.
#[test]
fn a_frame_on_the_last_row_is_a_tool() {
    for seed in 1..=4 {
        let tool = mounted_table::<3>(convention(seed), seed);
        let place = Placement::of_frames(&[tool.tool.frame]);
        let body = FixedFrame {
            mass: tool.tool.mass,
            com: tool.tool.com,
            inertia: tool.tool.inertia,
            ..FixedFrame::new(Some(2), place)
        };
        let on_base = FixedFrame { on: None, ..body };
        let frames = [on_base, body][..].into();
        let framed = Table {
            frames,
            tool: Tool::NONE,
            ..tool.clone()
        };
        assert_eq!(framed.total_mass(), tool.total_mass());
        let (framed, tool) = (NewtonEuler::new(&framed), NewtonEuler::new(&tool));
        let State { q, qd, qdd } = random_state::<3>(seed);
        let tau = tool.inverse_dynamics(&q, &qd, &qdd);
        assert_eq!(framed.inverse_dynamics(&q, &qd, &qdd), tau);
        assert_eq!(framed.center_of_mass(&q), tool.center_of_mass(&q));
        assert_eq!(framed.potential_energy(&q), tool.potential_energy(&q));
        assert_near(framed.frame_pose(1, &q), tool.forward_kinematics(&q));
        assert_near(framed.frame_jacobian(1, &q), tool.jacobian(&q));
        assert_near(
            framed.frame_jacobian_rate(1, &q, &qd),
            tool.jacobian_rate(&q, &qd),
        );
        assert_eq!(framed.frame_jacobian(0, &q).amax(), 0.0);
    }
}

/// Frames of any number are those of the table, and their bodies count.
#[test]
fn frames_without_number() {
    let (rows, frames, table) = tree(3);
    let many: [FixedFrame; 20] = core::array::from_fn(|i| frames[i % 7]);
    let motions = [JointMotion::Free; 6];
    let fixed = Table::<6>::with_frames(table.convention, table.gravity, rows, motions, many);
    let sized = RuntimeTable::with_frames(table.convention, table.gravity, &rows, &motions, &many);
    assert_eq!(fixed.frames.len(), 20);
    assert_eq!(sized.of_joints().as_ref(), Some(&fixed));
    let q = SVector::from([0.3, -0.2, 0.9, 0.4, -1.2, 0.7]);
    let expected =
        NumericArm::<Dyn>::new(&sized).gravity_vector(&DVector::from_column_slice(q.as_slice()));
    let found = NewtonEuler::new(&fixed).gravity_vector(&q);
    assert_abs_diff_eq!(found.as_slice(), expected.as_slice(), epsilon = 1e-12);
}

#[test]
#[should_panic = "row 1 of the table stands on row 2, which does not stand above it"]
fn a_row_does_not_stand_on_one_below() {
    let mut table = general_table::<3>(Convention::Modified, 1);
    table.rows[1].on = Carrier::Row(2);
    NewtonEuler::new(&table);
}

#[test]
#[should_panic = "a frame stands on row 3 of a table of 3 rows"]
fn a_frame_does_not_stand_on_a_row_that_is_not_there() {
    let mut table = general_table::<3>(Convention::Modified, 1);
    table
        .frames
        .push(FixedFrame::new(Some(3), Placement::IDENTITY));
    NewtonEuler::new(&table);
}

#[test]
#[should_panic = "a tool stands at the tip, and several rows carry no other"]
fn a_tool_stands_at_a_tip() {
    let mut table = mounted_table::<3>(Convention::Modified, 1);
    table.rows[2].on = Carrier::Row(0);
    NewtonEuler::new(&table);
}
