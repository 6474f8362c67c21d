//! The constant geometry between the axes of an arm.

use crate::derive::place::place;
use crate::derive::rows::constant_turn;
use crate::exact::Rational;
use crate::linear::{Ring, Vector3};
use crate::mechanism::{Law, Mechanism, Tree};
use crate::robot::Interpretation;
use crate::spatial::{Axis, AxisMotion, Body, Joint, Place, Turn};

/// The constant geometry between the frames of two links.
#[derive(Clone, Debug)]
pub(crate) struct LinkGeometry<R> {
    pub(crate) axis_motion: AxisMotion,
    /// Whether the joint stands still: all parameters of the link then move to the link before it.
    pub(crate) stands: bool,
    /// Whether the joint carries a base that moves: it stands at zero, and the link keeps all of its parameters.
    pub(crate) is_of_base: bool,
    /// The place of the joint's axis in the frame of the link before.
    pub(crate) before: Place<R>,
    /// Offset along the joint's axis (its constant part, if the joint is prismatic and moves).
    pub(crate) d: R,
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

impl<R: Ring> LinkGeometry<R> {
    /// The same in other numbers.
    pub(crate) fn map<S>(&self, number: impl Fn(R) -> S) -> LinkGeometry<S> {
        LinkGeometry {
            axis_motion: self.axis_motion,
            stands: self.stands,
            is_of_base: self.is_of_base,
            before: Place {
                origin: Vector3(self.before.origin.0.map(&number)),
                turns: self.before.turns.map(|turn| turn.map(&number)),
            },
            d: number(self.d),
            turn: self.turn.map(&number),
        }
    }
}

impl<R: Ring> Geometry<R> {
    /// Joint i where its variable is zero.
    pub(crate) fn joint(&self, i: usize) -> Joint<R> {
        let link = &self.links[i];
        Joint {
            zero: self.zero,
            axis_motion: link.axis_motion,
            before: Turn::none(self.zero, self.one),
            twist: link.before.turns.clone(),
            turn: link.turn,
            offset: self.offset(i),
            slide: self.zero,
        }
    }

    /// The axis of joint i in the frame of the link before.
    pub(crate) fn direction(&self, i: usize) -> Vector3<R> {
        let axis = Vector3::new(self.zero, self.zero, self.one);
        self.links[i].before.turns.leave(axis)
    }

    /// Where the origin of link i is in the frame of the link before, at q = 0 for a prismatic joint.
    pub(crate) fn offset(&self, i: usize) -> Vector3<R> {
        let (link, zero) = (&self.links[i], self.zero);
        let along = Vector3::new(zero, zero, link.d);
        link.before.turns.leave(along) + link.before.origin
    }

    /// A body of link i as a part of the link before, where the joint's variable is zero.
    pub(crate) fn leave(&self, i: usize, body: Body<R>) -> Body<R> {
        let link = &self.links[i];
        let turned = link.before.turns.leave_body(body.left(Axis::Z, link.turn));
        turned.moved(self.offset(i))
    }

    /// The same in other numbers.
    pub(crate) fn map<S>(&self, number: impl Fn(R) -> S) -> Geometry<S> {
        let links = self.links.iter().map(|link| link.map(&number));
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
    let joints = arm.joints.iter();
    let places: Vec<_> = joints.map(|joint| place(cells, &joint.before)).collect();
    let joints = arm.joints.iter().zip(places);
    let links = joints.map(|(joint, before)| {
        let mut d = cells.value(&joint.d);
        let turn = match (joint.axis_motion, &joint.law) {
            (AxisMotion::Turns, Law::Standing { at }) => {
                let at = Turn::from(cells.sin_cos(at));
                constant_turn(cells, &joint.turn).plus(at)
            }
            (AxisMotion::Turns, _) => Turn::none(zero, one),
            (AxisMotion::Slides, law) => {
                if let Law::Standing { at } = law {
                    d = d + cells.value(at);
                }
                constant_turn(cells, &joint.turn)
            }
        };
        LinkGeometry {
            axis_motion: joint.axis_motion,
            stands: joint.stands(),
            is_of_base: joint.is_of_base(),
            before,
            d,
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
