//! Joints that are locked or follow others: what a table says of the joints that are left.

use nalgebra::{Matrix3, Vector3};

#[cfg(feature = "std")]
use super::RuntimeTable;
use super::{
    Arm, Carrier, Convention, FixedFrame, FloatingBase, Follower, Frame, JointMotion, JointType,
    List, Placement, Row, Table, Tool, tip_row,
};
use crate::geometry::{Joint, Pose, SinCos, tensor};

impl<const N: usize> Table<N> {
    /// The table of an arm some of whose joints do not move. `positions` says for each of the L rows
    /// where its joint is locked, rad or m; `None` for a joint that moves. N joints must move, otherwise this
    /// panics.
    ///
    /// The link of a locked joint becomes a part of the link that carries it, or of the base; motors,
    /// friction and springs of locked joints are left out. The joints that move keep the link frames of the
    /// table; the tip of an arm without branches, to which a tool is fixed, stays the frame of the last row.
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
    /// themselves, otherwise this panics. Without the feature `std` at most 8 may follow one of those.
    pub fn couple<const L: usize>(
        convention: Convention,
        gravity: [f64; 3],
        rows: [Row; L],
        motions: [JointMotion; L],
    ) -> Self {
        Self::from_motions(None, (convention, gravity), &rows, &motions, &[])
    }

    /// As [`Table::couple`], with frames on the rows or on the base. Without the feature `std` the table has the first 16 of
    /// them. The body of any further one becomes a part of the link that carries it.
    ///
    /// This panics where [`Table::couple`] does, and if a frame stands on a row that is not there.
    pub fn with_frames<const L: usize, const F: usize>(
        convention: Convention,
        gravity: [f64; 3],
        rows: [Row; L],
        motions: [JointMotion; L],
        frames: [FixedFrame; F],
    ) -> Self {
        Self::from_motions(None, (convention, gravity), &rows, &motions, &frames)
    }

    /// As [`Table::with_frames`], on a base that moves. The links of rows that are locked to the base become parts of its body.
    pub fn with_floating_base<const L: usize, const F: usize>(
        base: FloatingBase,
        convention: Convention,
        gravity: [f64; 3],
        rows: [Row; L],
        motions: [JointMotion; L],
        frames: [FixedFrame; F],
    ) -> Self {
        let head = (convention, gravity);
        Self::from_motions(Some(&base), head, &rows, &motions, &frames)
    }

    /// The table of rows whose joints move so, on a base that moves if there is one.
    fn from_motions(
        base: Option<&FloatingBase>,
        (convention, gravity): (Convention, [f64; 3]),
        rows: &[Row],
        motions: &[JointMotion],
        frames: &[FixedFrame],
    ) -> Self {
        let mut joints = [Row::new(JointType::Revolute); N];
        let (mut followers, mut free) = (List::NONE, 0);
        let most = List::<FixedFrame, 16>::MOST;
        let (kept, bodies) = frames.split_at_checked(most).unwrap_or((frames, &[]));
        let rows = Rows {
            convention,
            rows,
            motions,
            bodies,
        };
        for row in rows.moving() {
            match row {
                Read::Joint(row) => {
                    assert!(free < N, "{N} joints move by themselves");
                    joints[free] = row;
                    free += 1;
                }
                Read::Follower(follower) => followers.push(follower),
            }
        }
        assert_eq!(free, N, "so many joints move by themselves");
        Table {
            floating: base.map(|base| rows.base(base)),
            tip: base.and_then(|_| rows.tip_on_base()),
            followers,
            frames: kept.iter().map(|frame| rows.frame(frame)).collect(),
            ..Table::new(convention, gravity, joints)
        }
    }
}

#[cfg(feature = "std")]
impl RuntimeTable {
    /// The table of a robot some of whose joints are locked or follow others. `motions` says for each row how its joint
    /// moves.
    pub fn couple(
        convention: Convention,
        gravity: [f64; 3],
        rows: &[Row],
        motions: &[JointMotion],
    ) -> Self {
        Self::with_frames(convention, gravity, rows, motions, &[])
    }

    /// As [`RuntimeTable::couple`], with frames on the rows or on the base. This panics if a frame stands on a row that is
    /// not there.
    pub fn with_frames(
        convention: Convention,
        gravity: [f64; 3],
        rows: &[Row],
        motions: &[JointMotion],
        frames: &[FixedFrame],
    ) -> Self {
        Self::from_motions(None, (convention, gravity), rows, motions, frames)
    }

    /// As [`RuntimeTable::with_frames`], on a base that moves. The links of rows that are locked to the base become parts of
    /// its body.
    pub fn with_floating_base(
        base: &FloatingBase,
        convention: Convention,
        gravity: [f64; 3],
        rows: &[Row],
        motions: &[JointMotion],
        frames: &[FixedFrame],
    ) -> Self {
        Self::from_motions(Some(base), (convention, gravity), rows, motions, frames)
    }

    /// The table of rows whose joints move so, on a base that moves if there is one.
    fn from_motions(
        base: Option<&FloatingBase>,
        (convention, gravity): (Convention, [f64; 3]),
        rows: &[Row],
        motions: &[JointMotion],
        frames: &[FixedFrame],
    ) -> Self {
        let mut table = RuntimeTable::new(convention, gravity, Vec::new());
        let rows = Rows {
            convention,
            rows,
            motions,
            bodies: &[],
        };
        table.floating = base.map(|base| rows.base(base));
        table.tip = base.and_then(|_| rows.tip_on_base());
        for row in rows.moving() {
            match row {
                Read::Joint(row) => table.rows.push(row),
                Read::Follower(follower) => table.followers.push(follower),
            }
        }
        table.frames = frames.iter().map(|frame| rows.frame(frame)).collect();
        table
    }
}

/// A row whose joint moves.
enum Read {
    Joint(Row),
    Follower(Follower),
}

/// The rows of a table, some of whose joints are locked or follow others.
#[derive(Clone, Copy)]
struct Rows<'t> {
    convention: Convention,
    rows: &'t [Row],
    motions: &'t [JointMotion],
    /// Frames of which the bodies alone are read: as parts of the links that carry them.
    bodies: &'t [FixedFrame],
}

impl Rows<'_> {
    /// The rows whose joints move, from the base outwards. Links that locked joints fix to a row's link are a part of it.
    fn moving(self) -> impl Iterator<Item = Read> {
        let rows = (0..self.rows.len()).filter(move |i| self.moves(*i));
        rows.map(move |i| {
            let row = self.joined(i);
            match self.motions[i] {
                JointMotion::Follows {
                    leader,
                    factor,
                    offset,
                } => Read::Follower(Follower {
                    row,
                    place: self.free_above(i),
                    leader: self.free_above(leader),
                    factor,
                    offset,
                }),
                _ => Read::Joint(row),
            }
        })
    }

    fn moves(&self, row: usize) -> bool {
        !matches!(self.motions[row], JointMotion::Locked(_))
    }

    fn free_above(&self, row: usize) -> usize {
        let above = self.motions[..row].iter();
        above.filter(|motion| **motion == JointMotion::Free).count()
    }

    /// The number of a moving row among those that move.
    fn number(&self, row: usize) -> usize {
        (0..row).filter(|above| self.moves(*above)).count()
    }

    /// The moving row with which the link of a row moves: its own, or the nearest one that carries it.
    fn mover(&self, row: usize) -> Option<usize> {
        let mut here = Some(row);
        while let Some(locked) = here.filter(|row| !self.moves(*row)) {
            here = self.rows[locked].on.of(locked);
        }
        here
    }

    /// Where the four parameters of a row begin, behind the joint of the moving row that carries it.
    fn start(&self, row: usize) -> Pose {
        let carrier = self.rows[row].on.of(row);
        let start = carrier.map_or(Pose::IDENTITY, |carrier| self.behind(carrier));
        start.then(&(&self.rows[row].mount).into())
    }

    /// The frame behind the joint of a row, behind the joint of the moving row with which it moves.
    fn behind(&self, row: usize) -> Pose {
        match self.motions[row] {
            JointMotion::Locked(position) => {
                let transform = transform(self.convention, &self.rows[row], position);
                self.start(row).then(&transform)
            }
            _ => Pose::IDENTITY,
        }
    }

    /// The link frame of a row in that of the moving row with which it moves, or in the base frame.
    fn in_mover(&self, row: usize) -> Pose {
        let mover = self.mover(row);
        if mover == Some(row) {
            return Pose::IDENTITY;
        }
        let link_frame = |row: usize| Pose::from(&self.rows[row].link_frame);
        let back = mover.map_or(Pose::IDENTITY, |mover| link_frame(mover).inverse());
        back.then(&self.behind(row)).then(&link_frame(row))
    }

    /// A moving row as it is in the table of the rows that move.
    fn joined(&self, row: usize) -> Row {
        let carrier = self.rows[row].on.of(row);
        let carrier = carrier.and_then(|carrier| self.mover(carrier));
        let on = match carrier.map(|carrier| self.number(carrier)) {
            on if on == self.number(row).checked_sub(1) => Carrier::Above,
            Some(carrier) => Carrier::Row(carrier),
            None => Carrier::Base,
        };
        let mount = self.start(row).placement();
        let mut joined = Row {
            on,
            mount,
            ..self.rows[row]
        };
        let moves_with = |other: &usize| self.mover(*other) == Some(row);
        for locked in (row + 1..self.rows.len()).filter(moves_with) {
            join(&mut joined, &self.rows[locked], &self.in_mover(locked));
        }
        for frame in self.bodies.iter().map(|frame| self.frame(frame)) {
            if frame.on == Some(self.number(row)) {
                join(&mut joined, &frame.body(), &(&frame.place).into());
            }
        }
        let is_behind = |at: &usize| *at != row && moves_with(at);
        if let Some(at) = tip_row(self.rows.iter()).filter(is_behind) {
            joined.tip = Some(self.tip_in_mover(at));
        }
        joined
    }

    /// The tip, which is on a row, in the link frame of the moving row with which it moves, or in the base frame.
    fn tip_in_mover(&self, row: usize) -> Placement {
        let tip = self.rows[row].tip_in_link();
        self.in_mover(row).then(&tip).placement()
    }

    /// The tip in the base frame, where all rows are locked.
    fn tip_on_base(&self) -> Option<Placement> {
        let is_fixed = |row: &usize| self.mover(*row).is_none();
        let tip = tip_row(self.rows.iter()).filter(is_fixed);
        tip.map(|row| self.tip_in_mover(row))
    }

    /// The body of a base that moves, with the links that are locked to it.
    fn base(&self, base: &FloatingBase) -> FloatingBase {
        let mut body = base.row();
        let is_fixed = |row: &usize| self.mover(*row).is_none();
        for locked in (0..self.rows.len()).filter(is_fixed) {
            join(&mut body, &self.rows[locked], &self.in_mover(locked));
        }
        let frames = self.bodies.iter().map(|frame| self.frame(frame));
        for frame in frames.filter(|frame| frame.on.is_none()) {
            join(&mut body, &frame.body(), &(&frame.place).into());
        }
        FloatingBase {
            mass: body.mass,
            com: body.com,
            inertia: body.inertia,
        }
    }

    /// A frame as it is in the table of the rows that move.
    fn frame(&self, frame: &FixedFrame) -> FixedFrame {
        let Some(row) = frame.on else { return *frame };
        frame.assert_stands_on(self.rows.len());
        let place = self.in_mover(row).then(&(&frame.place).into());
        FixedFrame {
            on: self.mover(row).map(|mover| self.number(mover)),
            place: place.placement(),
            ..*frame
        }
    }
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

#[doc(hidden)]
impl Arm<'_> {
    /// Row k of all rows with the bodies that are fixed to its link: those of frames, and the tool if the tip is there.
    pub fn with_bodies(self, k: usize, row: &Row) -> Row {
        let mut joined = *row;
        if *self.tool != Tool::NONE && self.tip_row() == Some(k) {
            joined = self.tool.joined(row);
        }
        for frame in self.frames.iter().filter(|frame| frame.on == Some(k)) {
            join(&mut joined, &frame.body(), &(&frame.place).into());
        }
        joined
    }

    /// The body of a base that moves, with all that is fixed to it: bodies of frames, and the tool of a robot without joints.
    pub fn base_body(self) -> Option<Row> {
        let mut body = self.floating?.row();
        if self.rows.is_empty() {
            body.tip = self.tip.copied();
            body = self.tool.joined(&body);
        }
        for frame in self.frames.iter().filter(|frame| frame.on.is_none()) {
            join(&mut body, &frame.body(), &(&frame.place).into());
        }
        Some(body)
    }
}

impl FloatingBase {
    /// The body, as that of a row.
    fn row(&self) -> Row {
        Row {
            mass: self.mass,
            com: self.com,
            inertia: self.inertia,
            ..Row::new(JointType::Revolute)
        }
    }
}

impl Tool {
    /// The tool as a part of the last link: its body, and the tip.
    fn joined(&self, last: &Row) -> Row {
        let tip = last.tip_in_link().then(&(&self.frame).into());
        let body = Row {
            mass: self.mass,
            com: self.com,
            inertia: self.inertia,
            ..Row::new(JointType::Revolute)
        };
        let mut joined = Row {
            tip: Some(tip.placement()),
            ..*last
        };
        join(&mut joined, &body, &tip);
        joined
    }
}

#[doc(hidden)]
impl Row {
    /// The tip in the link frame: where the row says, or else the link frame.
    pub fn tip_in_link(&self) -> Pose {
        self.tip.as_ref().map_or(Pose::IDENTITY, Pose::from)
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
