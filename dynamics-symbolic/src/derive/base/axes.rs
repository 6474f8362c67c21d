//! The axes in which a sliding link's first moments are written.

use super::geometry::LinkGeometry;
use crate::linear::{Matrix3, Ring, Vector3};
use crate::robot::JointType;
use crate::spatial::{leave_x, leave_z};

/// The last revolute joint before a prismatic one: the links between do not turn against each other.
pub(super) fn last_revolute<R>(links: &[LinkGeometry<R>], i: usize) -> Option<usize> {
    (0..i)
        .rev()
        .find(|&j| links[j].joint_type == JointType::Revolute && !links[j].locked)
}

/// The constant rotation from link i's axes to those of link `to`, with prismatic joints only
/// after link `to`.
pub(super) fn rotation<R: Ring>(
    links: &[LinkGeometry<R>],
    i: usize,
    to: usize,
    (zero, one): (R, R),
) -> Matrix3<R> {
    let image = |mut v: Vector3<R>| {
        for link in links[to + 1..=i].iter().rev() {
            v = leave_x(link.twist, leave_z(link.turn, v));
        }
        v.0
    };
    let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
    Matrix3(axes.map(|axis| image(Vector3(axis)))).transpose()
}
