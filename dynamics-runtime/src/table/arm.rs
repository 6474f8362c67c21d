//! Tables of any number of joints, as the numeric algorithms read them.

use super::{Convention, FixedFrame, Follower, Placement, Row, Table};
use crate::frame::{FloatingBase, Frame, Tool};

/// The contents of a table, whatever its size.
#[derive(Clone, Copy, Debug)]
pub struct Arm<'t> {
    /// How rows place their frames.
    pub convention: Convention,
    /// The acceleration of gravity in the axes of the world, m/s^2.
    pub gravity: [f64; 3],
    /// Where a base stands.
    pub base: &'t Frame,
    /// The body of a base that moves.
    pub floating: Option<&'t FloatingBase>,
    /// The rows of joints that move by themselves.
    pub rows: &'t [Row],
    /// The rows of joints that follow others.
    pub followers: &'t [Follower],
    /// The frames and their bodies.
    pub frames: &'t [FixedFrame],
    /// The tool; none has no body.
    pub tool: &'t Tool,
    /// The tip in the base frame, of a robot without joints.
    pub tip: Option<&'t Placement>,
}

/// A row of the whole arm, and how its joint moves: at `factor * q + offset` with the position q of a joint that moves
/// by itself.
#[derive(Clone, Copy, Debug)]
pub struct Moving<'t> {
    /// The row.
    pub row: &'t Row,
    /// The joint of q with which it moves.
    pub joint: usize,
    /// 1 and 0 of a joint that moves by itself.
    pub factor: f64,
    /// The position at q = 0.
    pub offset: f64,
    /// Whether it follows another joint.
    pub is_follower: bool,
}

impl<'t> Arm<'t> {
    /// All rows from the base outwards, those of followers in their places.
    pub fn chain(self) -> impl Iterator<Item = Moving<'t>> + Clone {
        let followers_at = move |place: usize| {
            let followers = self.followers.iter();
            followers
                .filter(move |follower| follower.place == place)
                .map(|follower| Moving {
                    row: &follower.row,
                    joint: follower.leader,
                    factor: follower.factor,
                    offset: follower.offset,
                    is_follower: true,
                })
        };
        let joints = self.rows.iter().enumerate();
        let with_followers = joints.flat_map(move |(joint, row)| {
            let own = Moving {
                row,
                joint,
                factor: 1.0,
                offset: 0.0,
                is_follower: false,
            };
            followers_at(joint).chain(core::iter::once(own))
        });
        with_followers.chain(followers_at(self.rows.len()))
    }

    /// Its degrees of freedom: six of a base that moves, then one for each joint.
    #[cfg(feature = "std")]
    pub fn freedoms(self) -> usize {
        self.freedoms_of_base() + self.rows.len()
    }

    /// Six of a base that moves, and none of one that stands.
    #[cfg(feature = "std")]
    fn freedoms_of_base(self) -> usize {
        6 * usize::from(self.floating.is_some())
    }

    /// The joint of a degree of freedom, counted from 0; `None` for those of a base that moves.
    #[cfg(feature = "std")]
    pub fn joint_of(self, freedom: usize) -> Option<usize> {
        freedom.checked_sub(self.freedoms_of_base())
    }

    /// The row of the tip. `None` where several rows carry no other and none of them has it, and for no rows.
    pub fn tip_row(self) -> Option<usize> {
        tip_row(self.chain().map(|moving| moving.row))
    }

    /// Mass of all links, of the tool, of the bodies of frames on links and of a base that moves, with what is fixed to it, kg.
    pub fn total_mass(self) -> f64 {
        let moves = self.floating.is_some();
        let moving = |frame: &&FixedFrame| moves || frame.on.is_some();
        let on_links = self.frames.iter().filter(moving);
        let of_frames = on_links.map(|frame| frame.mass).sum::<f64>();
        let of_base = self.floating.map_or(0.0, |base| base.mass);
        let of_links = self.chain().map(|moving| moving.row.mass).sum::<f64>();
        of_links + self.tool.mass + of_frames + of_base
    }
}

/// The row that has the tip, or else the only one that carries no other: the last one where there are no branches.
pub(crate) fn tip_row<'r>(rows: impl Iterator<Item = &'r Row> + Clone) -> Option<usize> {
    let is_serial = |(k, row): (usize, &Row)| row.on.of(k) == k.checked_sub(1);
    let mut numbered = rows.clone().enumerate();
    let has_tip = rows.clone().position(|row| row.tip.is_some());
    has_tip.or_else(|| {
        rows.count()
            .checked_sub(1)
            .filter(|_| numbered.all(is_serial))
    })
}

/// A table that the numeric algorithms read.
pub trait AsArm {
    /// Its contents, whatever its size.
    #[doc(hidden)]
    fn arm(&self) -> Arm<'_>;
}

impl<const N: usize> AsArm for Table<N> {
    fn arm(&self) -> Arm<'_> {
        Arm {
            convention: self.convention,
            gravity: self.gravity,
            base: &self.base,
            floating: self.floating.as_ref(),
            rows: &self.rows,
            followers: &self.followers,
            frames: &self.frames,
            tool: &self.tool,
            tip: self.tip.as_ref(),
        }
    }
}
