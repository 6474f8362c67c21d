//! Joints that are locked: a table without them.

use nalgebra::{Matrix3, Vector3};

use super::angle::SinCos;
use super::inertia::tensor;
use super::joint::Joint;
use super::pose::Pose;
use crate::{Convention, Frame, JointType, Placement, Row, Table, Tool};

impl<const N: usize> Table<N> {
    /// The table of an arm some of whose joints do not move. `positions` says for each of the L rows
    /// where its joint is locked, rad or m; `None` for a joint that moves. N joints must move, otherwise this
    /// panics.
    ///
    /// The link of a locked joint becomes a part of the link before it, or of the base; motors,
    /// friction and springs of locked joints are left out. The joints that move keep the link frames of the
    /// table; the tip, to which a tool is fixed, stays the frame of the last row.
    pub fn lock<const L: usize>(
        convention: Convention,
        gravity: [f64; 3],
        rows: [Row; L],
        positions: [Option<f64>; L],
    ) -> Self {
        Self::lock_rows(convention, gravity, &rows, &positions)
    }

    /// [`Table::lock`] with a slice of rows.
    #[doc(hidden)]
    pub fn lock_rows(
        convention: Convention,
        gravity: [f64; 3],
        rows: &[Row],
        positions: &[Option<f64>],
    ) -> Self {
        let mut moving = [Row::new(JointType::Revolute); N];
        let count = without_locked(convention, rows, positions.iter().copied(), &mut moving);
        assert_eq!(count, N, "so many joints move");
        Table::new(convention, gravity, moving)
    }
}

/// The link frame of a row that begins at `start` behind the joint of another one, in that one's link frame.
/// A moving row begins at itself.
fn in_link_frame(link: &Row, start: &Pose, row: &Row) -> Pose {
    let back = Pose::from(&link.link_frame).inverse();
    back.then(start).then(&(&row.link_frame).into())
}

/// Writes the rows whose joints move to the start of `moving`, which has a place for each of them, and
/// returns how many they are.
pub(super) fn without_locked(
    convention: Convention,
    rows: &[Row],
    positions: impl Iterator<Item = Option<f64>>,
    moving: &mut [Row],
) -> usize {
    let mut count = 0;
    let mut start = Pose::identity();
    for (row, position) in rows.iter().zip(positions) {
        match position {
            None => {
                moving[count] = *row;
                moving[count].mount = start.placement();
                count += 1;
                start = Pose::identity();
            }
            Some(position) => {
                start = start.then(&transform(convention, row, position));
                if let Some(link) = count.checked_sub(1) {
                    let pose = in_link_frame(&moving[link], &start, row);
                    join(&mut moving[link], row, &pose);
                }
            }
        }
        if let Some(link) = count.checked_sub(1) {
            moving[link].tip = in_link_frame(&moving[link], &start, row).placement();
        }
    }
    count
}

/// The row's frame in the one before it, with the joint at that position.
fn transform(convention: Convention, row: &Row, position: f64) -> Pose {
    let (turned, distance) = match row.joint_type {
        JointType::Revolute => (SinCos::of_constant(position), 0.0),
        JointType::Prismatic => (SinCos::ZERO, position),
    };
    let theta = turned.plus(SinCos::of_constant(row.theta));
    let screw_z = Joint::new(SinCos::ZERO, 0.0, theta, row.d + distance).pose();
    let screw_x = Joint::along_x(SinCos::of_constant(row.alpha), row.a);
    match convention {
        Convention::Standard => screw_z.then(&screw_x),
        Convention::Modified => screw_x.then(&screw_z),
    }
}

impl Placement {
    /// The last of some frames, each given in the one before it, in the frame in which the first one is given.
    pub fn of_frames(frames: &[Frame]) -> Self {
        let places = frames.iter().map(Pose::from);
        let last = places.fold(Pose::identity(), |pose, place| pose.then(&place));
        last.placement()
    }
}

impl Tool {
    /// The tool as a part of the last link: its body, and the tip.
    pub(super) fn joined(&self, last: &Row) -> Row {
        let tip = Pose::from(&last.tip).then(&(&self.frame).into());
        let body = Row {
            mass: self.mass,
            com: self.com,
            inertia: self.inertia,
            ..Row::new(JointType::Revolute)
        };
        let mut joined = Row {
            tip: tip.placement(),
            ..*last
        };
        join(&mut joined, &body, &tip);
        joined
    }
}

/// Adds the body of `locked`, whose frame is at `pose` in the link frame of `row`:
/// I = I_1 + R I_2 R^T + m_1 m_2 / (m_1 + m_2) (r.r 1 - r r^T), with r from one centre to the other.
fn join(row: &mut Row, locked: &Row, pose: &Pose) {
    let mass = row.mass + locked.mass;
    let com = Vector3::from(row.com);
    let apart = pose.rotation * Vector3::from(locked.com) + pose.position - com;
    let share = match mass == 0.0 {
        true => 0.0,
        false => locked.mass / mass,
    };
    let reduced = row.mass * share;
    let steiner = Matrix3::from_diagonal_element(apart.norm_squared()) - apart * apart.transpose();
    let tensor = tensor(row)
        + pose.rotation * tensor(locked) * pose.rotation.transpose()
        + steiner * reduced;
    row.mass = mass;
    row.com = (com + apart * share).into();
    row.inertia = [
        tensor.m11, tensor.m22, tensor.m33, tensor.m12, tensor.m23, tensor.m13,
    ];
}
