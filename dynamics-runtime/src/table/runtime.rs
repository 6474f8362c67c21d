//! A table whose number of joints is known at run time alone.

use super::{Arm, AsArm, Convention, FixedFrame, Follower, Placement, Row, Table};
use crate::frame::{FloatingBase, Frame, Tool};

/// The table of a robot whose number of joints is known at run time alone, as numbers. Nothing is validated.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RuntimeTable {
    /// Convention of the rows.
    pub convention: Convention,
    /// Acceleration of gravity in the axes of the world, m/s^2.
    pub gravity: [f64; 3],
    /// The base frame, frame 0, in the world.
    pub base: Frame,
    /// The body of a base that moves, as in [`Table::floating`].
    #[cfg_attr(feature = "serde", serde(default))]
    pub floating: Option<FloatingBase>,
    /// The rows of the joints, from the base outwards: each one behind the row that carries it.
    pub rows: Vec<Row>,
    /// Frames on the links, and the bodies in them.
    #[cfg_attr(feature = "serde", serde(default))]
    pub frames: Vec<FixedFrame>,
    /// The tool at the tip, as in [`Table::tool`].
    pub tool: Tool,
    /// The tip of a robot whose rows are all locked, as in [`Table::tip`].
    #[cfg_attr(feature = "serde", serde(default))]
    pub tip: Option<Placement>,
    pub(crate) followers: Vec<Follower>,
}

impl RuntimeTable {
    /// An arm whose base frame is the world's, without a tool.
    pub fn new(convention: Convention, gravity: [f64; 3], rows: Vec<Row>) -> Self {
        RuntimeTable {
            convention,
            gravity,
            base: Frame::IDENTITY,
            floating: None,
            rows,
            frames: Vec::new(),
            tool: Tool::NONE,
            tip: None,
            followers: Vec::new(),
        }
    }

    /// The rows of the joints that follow others.
    pub fn followers(&self) -> impl Iterator<Item = &Follower> {
        self.followers.iter()
    }

    /// The same table for an arm of `N` joints; `None` if it has another number of joints.
    pub fn of_joints<const N: usize>(&self) -> Option<Table<N>> {
        let rows = <[Row; N]>::try_from(&self.rows[..]).ok()?;
        Some(Table {
            base: self.base,
            floating: self.floating,
            followers: self.followers[..].into(),
            frames: self.frames[..].into(),
            tool: self.tool,
            tip: self.tip,
            ..Table::new(self.convention, self.gravity, rows)
        })
    }
}

/// The same table, its number of joints forgotten.
impl<const N: usize> From<&Table<N>> for RuntimeTable {
    fn from(table: &Table<N>) -> Self {
        RuntimeTable {
            convention: table.convention,
            gravity: table.gravity,
            base: table.base,
            floating: table.floating,
            rows: table.rows.to_vec(),
            frames: table.frames.to_vec(),
            tool: table.tool,
            tip: table.tip,
            followers: table.followers.to_vec(),
        }
    }
}

impl AsArm for RuntimeTable {
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
