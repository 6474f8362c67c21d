//! The constant geometry between the axes of an arm.

use crate::derive::rows::screws;
use crate::exact::Rational;
use crate::linear::{Ring, Vector3};
use crate::robot::{Interpretation, JointType, Robot};
use crate::spatial::{Joint, Turn, leave_x};

/// The constant geometry between the frames of two links.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkGeometry<R> {
    pub(crate) joint_type: JointType,
    /// Whether the joint is locked: all parameters of the link then move to the link before it.
    pub(crate) locked: bool,
    /// Distance of the joint's axis from the previous one.
    pub(crate) a: R,
    /// Offset along the joint's axis (its constant part, where the joint is prismatic and moves).
    pub(crate) d: R,
    /// Turn about x from the previous axis to this one.
    pub(crate) twist: Turn<R>,
    /// Turn about z that is constant: of a prismatic or a locked joint, else none.
    pub(crate) turn: Turn<R>,
}

impl<R: Ring> LinkGeometry<R> {
    /// The joint where its variable is zero.
    pub(crate) fn joint(&self, zero: R, one: R) -> Joint<R> {
        Joint {
            joint_type: self.joint_type,
            before: Turn::none(zero, one),
            twist: self.twist,
            turn: self.turn,
            offset: self.offset(zero),
            slide: zero,
        }
    }

    /// Where the origin is in the previous frame, at q = 0 for a prismatic joint.
    pub(crate) fn offset(&self, zero: R) -> Vector3<R> {
        leave_x(self.twist, Vector3::new(zero, zero, self.d)) + Vector3::new(self.a, zero, zero)
    }
}

/// The constant geometry of every link.
pub(crate) fn geometry<I: Interpretation>(
    cells: &mut I,
    robot: &Robot,
) -> Vec<LinkGeometry<I::Number>> {
    let zero = cells.rational(&Rational::ZERO);
    let one = cells.rational(&Rational::ONE);
    let screws = screws(cells, robot);
    let rows = robot.rows.iter().zip(&screws);
    rows.map(|(row, screw)| {
        let mut d = cells.value(&row.d);
        let (s, c) = match (row.joint_type, &row.locked) {
            (JointType::Revolute, None) => (zero, one),
            (JointType::Revolute, Some(position)) => {
                let turned = Turn::from(cells.sin_cos(position));
                let theta = Turn::from(cells.sin_cos(&row.theta)).plus(turned);
                (theta.s, theta.c)
            }
            (JointType::Prismatic, locked) => {
                if let Some(position) = locked {
                    d = d + cells.value(position);
                }
                cells.sin_cos(&row.theta)
            }
        };
        LinkGeometry {
            joint_type: row.joint_type,
            locked: row.locked.is_some(),
            a: screw.a,
            d,
            twist: screw.turn,
            turn: Turn { s, c },
        }
    })
    .collect()
}
