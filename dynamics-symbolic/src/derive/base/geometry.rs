//! The constant geometry between the axes of an arm.

use crate::derive::rows::{Screws, constant_turn};
use crate::exact::Rational;
use crate::linear::{Ring, Vector3};
use crate::mechanism::{Law, Mechanism, Tree};
use crate::robot::{Interpretation, JointType};
use crate::spatial::{Body, Joint, Turn, leave_x};

/// The constant geometry between the frames of two links.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkGeometry<R> {
    pub(crate) joint_type: JointType,
    /// Whether the joint stands still: all parameters of the link then move to the link before it.
    pub(crate) stands: bool,
    /// Distance of the joint's axis from the previous one.
    pub(crate) a: R,
    /// Offset along the joint's axis (its constant part, if the joint is prismatic and moves).
    pub(crate) d: R,
    /// Turn about x from the previous axis to this one.
    pub(crate) twist: Turn<R>,
    /// Turn about z that is constant: of a prismatic joint or one that stands still, else none.
    pub(crate) turn: Turn<R>,
}

/// The constant geometry of an arm.
#[derive(Clone, Debug)]
pub(crate) struct Geometry<R> {
    pub(crate) zero: R,
    pub(crate) one: R,
    pub(crate) tree: Tree,
    pub(crate) links: Vec<LinkGeometry<R>>,
}

impl<R: Ring> Geometry<R> {
    /// Joint i where its variable is zero.
    pub(crate) fn joint(&self, i: usize) -> Joint<R> {
        let link = &self.links[i];
        Joint {
            joint_type: link.joint_type,
            before: Turn::none(self.zero, self.one),
            twist: link.twist,
            turn: link.turn,
            offset: self.offset(i),
            slide: self.zero,
        }
    }

    /// Where the origin of link i is in the frame of the link before, at q = 0 for a prismatic joint.
    pub(crate) fn offset(&self, i: usize) -> Vector3<R> {
        let (link, zero) = (&self.links[i], self.zero);
        leave_x(link.twist, Vector3::new(zero, zero, link.d)) + Vector3::new(link.a, zero, zero)
    }

    /// A body of link i as a part of the link before, where the joint's variable is zero.
    pub(crate) fn leave(&self, i: usize, body: Body<R>) -> Body<R> {
        let link = &self.links[i];
        let turned = body.left_z(link.turn).left_x(link.twist);
        turned.moved(self.offset(i))
    }

    /// The same in other numbers.
    pub(crate) fn map<S>(&self, number: impl Fn(R) -> S) -> Geometry<S> {
        let links = self.links.iter().map(|link| LinkGeometry {
            joint_type: link.joint_type,
            stands: link.stands,
            a: number(link.a),
            d: number(link.d),
            twist: link.twist.map(&number),
            turn: link.turn.map(&number),
        });
        Geometry {
            zero: number(self.zero),
            one: number(self.one),
            tree: self.tree.clone(),
            links: links.collect(),
        }
    }
}

/// The constant geometry of an arm.
pub(crate) fn geometry<I: Interpretation>(cells: &mut I, arm: &Mechanism) -> Geometry<I::Number> {
    let zero = cells.rational(&Rational::ZERO);
    let one = cells.rational(&Rational::ONE);
    let screws = Screws::new(cells, arm).before;
    let joints = arm.joints.iter().zip(&screws);
    let links = joints.map(|(joint, screw)| {
        let mut d = cells.value(&joint.d);
        let turn = match (joint.joint_type, &joint.law) {
            (JointType::Revolute, Law::Standing { at }) => {
                let at = Turn::from(cells.sin_cos(at));
                constant_turn(cells, joint).plus(at)
            }
            (JointType::Revolute, _) => Turn::none(zero, one),
            (JointType::Prismatic, law) => {
                if let Law::Standing { at } = law {
                    d = d + cells.value(at);
                }
                constant_turn(cells, joint)
            }
        };
        LinkGeometry {
            joint_type: joint.joint_type,
            stands: joint.stands(),
            a: screw.a,
            d,
            twist: screw.turn,
            turn,
        }
    });
    Geometry {
        zero,
        one,
        links: links.collect(),
        tree: arm.tree.clone(),
    }
}
