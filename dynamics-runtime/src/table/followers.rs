//! Joints that follow others: rows of the table that are none of its joints.

use super::Row;

/// A joint that follows another one, at `factor * q + offset` with the position q of that one, and its link.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Follower {
    /// Its row.
    pub row: Row,
    /// How many of the rows in [`Table::rows`](super::Table::rows) come before this one. Followers with the same number
    /// follow one another in their order.
    pub place: usize,
    /// The joint that it follows, by its index in [`Table::rows`](super::Table::rows).
    pub leader: usize,
    /// How far it moves for each unit of that joint.
    pub factor: f64,
    /// Where it is while that joint is at zero, rad or m.
    pub offset: f64,
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
