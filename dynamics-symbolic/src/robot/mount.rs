//! Axes anywhere in space.

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
