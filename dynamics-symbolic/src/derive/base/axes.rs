//! The axes in which a sliding link's first moments are written.

use super::geometry::Geometry;
use crate::linear::{Matrix3, Ring, Vector3};
use crate::spatial::{Axis, AxisMotion, leave_about};

impl<R: Ring> Geometry<R> {
    /// The last revolute joint before joint i, a prismatic one: the links between do not turn against each other.
    pub(super) fn last_revolute(&self, i: usize) -> Option<usize> {
        let turns = |&j: &usize| {
            let link = &self.links[j];
            link.axis_motion == AxisMotion::Turns && !link.stands && !link.is_of_base
        };
        self.tree.carriers(i).skip(1).find(turns)
    }

    /// The constant rotation from link i's axes to those of link `to`, with prismatic joints only
    /// after link `to`.
    pub(super) fn rotation(&self, i: usize, to: usize) -> Matrix3<R> {
        let image = |axis: [R; 3]| {
            let between = self.tree.carriers(i).take_while(|j| *j != to);
            let leave = |v, j: usize| {
                let link = &self.links[j];
                link.before.turns.leave(leave_about(Axis::Z, link.turn, v))
            };
            between.fold(Vector3(axis), leave).0
        };
        let (zero, one) = (self.zero, self.one);
        let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        Matrix3(axes.map(image)).transpose()
    }
}
