//! Frames that are fixed to links, and the bodies in them.

use super::{Placement, Row};
use crate::JointType;

/// A frame that is fixed to a link or to the base, and a body in it.
///
/// It has no name here: frames are counted, as rows are, in the order of the `frames` of a call or of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FixedFrame {
    /// The row whose link carries it, counted as in [`Carrier`](super::Carrier); `None` for the base.
    pub on: Option<usize>,
    /// The frame in the link frame of that row, or in the base frame.
    pub place: Placement,
    /// Mass of the body, kg. A body on a base that stands counts nowhere.
    pub mass: f64,
    /// Its centre of mass in the frame, m.
    pub com: [f64; 3],
    /// Entries xx, yy, zz, xy, yz, xz of its inertia tensor about the centre of mass, axes parallel to the frame, kg m^2.
    pub inertia: [f64; 6],
}

impl FixedFrame {
    /// A frame without a body.
    pub const fn new(on: Option<usize>, place: Placement) -> Self {
        FixedFrame {
            on,
            place,
            mass: 0.0,
            com: [0.0; 3],
            inertia: [0.0; 6],
        }
    }

    /// Panics unless it stands on the base or on one of so many rows.
    #[track_caller]
    #[doc(hidden)]
    pub fn assert_stands_on(&self, rows: usize) {
        if let Some(row) = self.on {
            assert!(
                row < rows,
                "a frame stands on row {row} of a table of {rows} rows: they are counted from 0"
            );
        }
    }

    /// Its body, as that of a row.
    pub(crate) fn body(&self) -> Row {
        Row {
            mass: self.mass,
            com: self.com,
            inertia: self.inertia,
            ..Row::new(JointType::Revolute)
        }
    }
}
