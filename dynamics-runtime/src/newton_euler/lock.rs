//! Joints that are locked or follow others: what a table says of the joints that are left.

use nalgebra::{Matrix3, Vector3};

use super::angle::SinCos;
use super::inertia::tensor;
use super::joint::Joint;
use super::pose::Pose;
#[cfg(feature = "std")]
use crate::RuntimeTable;
use crate::table::MOST_FOLLOWERS;
use crate::{
    Convention, Follower, Followers, Frame, JointMotion, JointType, Placement, Row, Table, Tool,
};

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
        let motions =
            positions.map(|position| position.map_or(JointMotion::Free, JointMotion::Locked));
        Self::couple(convention, gravity, rows, motions)
    }

    /// The table of an arm some of whose joints follow others; joints may be locked too, as in
    /// [`Table::lock`]. `motions` says for each of the L rows how its joint moves. N joints must move by
    /// themselves, and at most 8 may follow one of those: otherwise this panics.
    pub fn couple<const L: usize>(
        convention: Convention,
        gravity: [f64; 3],
        rows: [Row; L],
        motions: [JointMotion; L],
    ) -> Self {
        Self::couple_rows(convention, gravity, &rows, &motions)
    }

    /// [`Table::couple`] with a slice of rows.
    #[doc(hidden)]
    pub fn couple_rows(
        convention: Convention,
        gravity: [f64; 3],
        rows: &[Row],
        motions: &[JointMotion],
    ) -> Self {
        let mut joints = [Row::new(JointType::Revolute); N];
        let (mut followers, mut free) = (Followers::NONE, 0);
        for_moving_rows(convention, rows, motions, |row| match row {
            Read::Joint(row) => {
                assert!(free < N, "{N} joints move by themselves");
                joints[free] = row;
                free += 1;
            }
            Read::Follower(follower) => {
                let is_placed = followers.push(follower);
                assert!(is_placed, "at most {MOST_FOLLOWERS} joints follow others");
            }
        });
        assert_eq!(free, N, "so many joints move by themselves");
        Table {
            followers,
            ..Table::new(convention, gravity, joints)
        }
    }
}

#[cfg(feature = "std")]
impl RuntimeTable {
    /// The table of an arm some of whose joints are locked or follow others. `motions` says for each row how its joint
    /// moves.
    pub fn couple(
        convention: Convention,
        gravity: [f64; 3],
        rows: &[Row],
        motions: &[JointMotion],
    ) -> Self {
        let mut table = RuntimeTable::new(convention, gravity, Vec::new());
        for_moving_rows(convention, rows, motions, |row| match row {
            Read::Joint(row) => table.rows.push(row),
            Read::Follower(follower) => table.followers.push(Some(follower)),
        });
        table
    }
}

/// A row whose joint moves.
enum Read {
    Joint(Row),
    Follower(Follower),
}

/// Calls `found` for each row whose joint moves, from the base outwards. Links that locked joints fix to the row's link are
/// a part of it.
fn for_moving_rows(
    convention: Convention,
    rows: &[Row],
    motions: &[JointMotion],
    mut found: impl FnMut(Read),
) {
    let joint_of = |row: usize| {
        let before = motions[..row].iter();
        before
            .filter(|motion| **motion == JointMotion::Free)
            .count()
    };
    let mut joints = 0;
    let mut close = |(row, motion): (Row, JointMotion)| match motion {
        JointMotion::Follows {
            leader,
            factor,
            offset,
        } => found(Read::Follower(Follower {
            row,
            place: joints,
            leader: joint_of(leader),
            factor,
            offset,
        })),
        _ => {
            joints += 1;
            found(Read::Joint(row));
        }
    };
    // The last link that moves, and where the next row begins behind its joint.
    let (mut link, mut start) = (None::<(Row, JointMotion)>, Pose::IDENTITY);
    for (row, motion) in rows.iter().zip(motions) {
        start = start.then(&(&row.mount).into());
        if let JointMotion::Locked(position) = *motion {
            start = start.then(&transform(convention, row, position));
            if let Some((link, _)) = &mut link {
                let pose = in_link_frame(link, &start, row);
                join(link, row, &pose);
            }
        } else {
            let mount = start.placement();
            link.replace((Row { mount, ..*row }, *motion))
                .map(&mut close);
            start = Pose::IDENTITY;
        }
        if let Some((link, _)) = &mut link {
            let frame = in_link_frame(link, &start, row);
            link.tip = frame.then(&(&row.tip).into()).placement();
        }
    }
    link.map(close);
}

/// The link frame of a row that begins at `start` behind the joint of another one, in that one's link frame.
/// A moving row begins at itself.
fn in_link_frame(link: &Row, start: &Pose, row: &Row) -> Pose {
    let back = Pose::from(&link.link_frame).inverse();
    back.then(start).then(&(&row.link_frame).into())
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
        let last = places.fold(Pose::IDENTITY, |pose, place| pose.then(&place));
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
    let share = if mass == 0.0 { 0.0 } else { locked.mass / mass };
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
