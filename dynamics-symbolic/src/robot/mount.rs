//! Axes anywhere in space.
//!
//! The way of a mount:
//!
//! 1. `files::links` makes a mount of each joint: `places` in the link frame before, the axis by two angles, and
//!    behind the last link frame the `tip`. All numbers are those of the file. No later step makes rows of them.
//! 2. The joint's own frame has the origin of the link frame and the joint's axis as its z axis. `Robot::mounted`
//!    places it behind the joint that carries it.
//! 3. `mechanism::aligned` turns and slides frames along their own axes until the step to the next one is short.
//!    Quarter turns vanish, and other angles stay as they were written. A file of the Panda gives the programs of its
//!    table by that.
//! 4. A rotation that no quarter turns make is a list of turns about coordinate axes (`spatial::Turns`), each with a
//!    sine of its own.
//! 5. Base parameters refer to the joint's own frame, in `base::geometry` as in the proof. `Link::place` brings them
//!    into aligned frames.
//! 6. The proof multiplies the placements as they were written. It knows no aligned frame.

use super::{Placement, Value};

/// About which axis a joint moves, in a file that says so in place of the cells a, alpha, d and theta.
///
/// If the row begins at L', the link frame is L' S Rz(q) S^-1 (Tz(q) for a prismatic joint), S = Rz(azimuth) Ry(polar).
/// Base parameters refer to the joint's own frame, which is S behind the link frame: it has the link frame's origin,
/// and its z axis is that of the joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Mount<C = Value> {
    /// Azimuth and polar angle of the joint's axis in the frame in which the row begins, rad.
    pub axis: [C; 2],
    /// The tip, if it is on this link: in the link frame, each place in the one before it. At most one row has it.
    pub tip: Option<Vec<Placement<C>>>,
}

impl Mount {
    /// The joint's own frame in the frame in which the row begins.
    pub(super) fn turned(&self) -> Vec<Placement> {
        let [azimuth, polar] = self.axis.clone();
        turned([Value::zero(), polar, azimuth])
    }

    /// The link frame in the joint's own frame.
    pub(super) fn link_frame(&self) -> Vec<Placement> {
        let [azimuth, polar] = self.axis.each_ref().map(|angle| -angle.clone());
        let polar = turned([Value::zero(), polar, Value::zero()]);
        let azimuth = turned([Value::zero(), Value::zero(), azimuth]);
        [polar, azimuth].concat()
    }
}

/// A rotation, or nothing where there is none.
fn turned(rpy: [Value; 3]) -> Vec<Placement> {
    if rpy.iter().all(Value::is_zero) {
        return Vec::new();
    }
    let xyz = [0; 3].map(Value::integer);
    vec![Placement { xyz, rpy }]
}
