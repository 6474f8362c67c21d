//! Joints that follow others: rows of the table that are none of its joints.

use super::{Row, Table};

/// How many joints of an arm may follow others.
pub(crate) const MOST_FOLLOWERS: usize = 8;

/// A joint that follows another one, at `factor * q + offset` with the position q of that one, and its link.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Follower {
    /// Its row.
    pub row: Row,
    /// How many of the rows in [`Table::rows`] come before this one. Followers with the same number
    /// follow one another in their order.
    pub place: usize,
    /// The joint that it follows, by its index in [`Table::rows`].
    pub leader: usize,
    /// How far it moves for each unit of that joint.
    pub factor: f64,
    /// Where it is while that joint is at zero, rad or m.
    pub offset: f64,
}

/// The joints of an arm that follow others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Followers {
    list: [Option<Follower>; MOST_FOLLOWERS],
}

/// How the joint of a row moves, in a table with rows of every kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointMotion {
    /// By itself.
    Free,
    /// Not at all: it stays at this position, rad or m.
    Locked(f64),
    /// With another joint, at `factor * q + offset`.
    Follows {
        /// The row of the joint that it follows, which moves by itself.
        leader: usize,
        /// How far it moves for each unit of that joint.
        factor: f64,
        /// Where it is while that joint is at zero, rad or m.
        offset: f64,
    },
}

/// A row of the whole arm, and the joint by which it moves.
pub(crate) struct Moving<'t> {
    pub(crate) row: &'t Row,
    pub(crate) joint: usize,
    /// 1 and 0 of a joint that moves by itself.
    pub(crate) factor: f64,
    pub(crate) offset: f64,
    pub(crate) is_follower: bool,
}

impl Followers {
    /// None.
    pub const NONE: Followers = Followers {
        list: [None; MOST_FOLLOWERS],
    };

    /// The followers from the base outwards.
    pub fn iter(&self) -> impl Iterator<Item = &Follower> {
        self.list.iter().flatten()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.iter().next().is_none()
    }

    /// Adds one; `false` where there is no place for it.
    pub(crate) fn push(&mut self, follower: Follower) -> bool {
        let place = self.list.iter_mut().find(|place| place.is_none());
        place.map(|place| *place = Some(follower)).is_some()
    }
}

impl<const N: usize> Table<N> {
    /// All rows from the base outwards, those of followers in their places.
    pub(crate) fn chain(&self) -> impl Iterator<Item = Moving<'_>> {
        let followers_at = |place: usize| {
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
        with_followers.chain(followers_at(N))
    }
}
