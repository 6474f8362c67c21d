//! The constant geometry of a mechanism in any ring: between the axes of joints, and from these to link frames.

use super::place::{self, place};
use crate::exact::Rational;
use crate::linear::{Ring, Vector3};
use crate::mechanism::{FixedBody, Joint, Mechanism};
use crate::robot::{Interpretation, Placement, Value};
use crate::spatial::{Body, Central, Place, Turn};

/// The constant places of an arm.
pub(super) struct Places<R> {
    /// Places of each joint's axis, in the aligned frame of the joint before.
    pub(super) before: Vec<Place<R>>,
    /// Places of each joint's own frame, in its aligned frame.
    pub(super) own: Vec<Place<R>>,
    /// Places of each link frame, in the own frame of its joint.
    behind: Vec<Place<R>>,
}

impl<R: Ring> Places<R> {
    /// Reads them.
    pub(super) fn new<I: Interpretation<Number = R>>(cells: &mut I, arm: &Mechanism) -> Self {
        let mut all = |placements: fn(&Joint) -> &[Placement]| {
            let joints = arm.joints.iter();
            joints
                .map(|joint| place(cells, placements(joint)))
                .collect()
        };
        Places {
            before: all(|joint| &joint.aligned.before),
            own: all(|joint| &joint.aligned.own),
            behind: all(|joint| &joint.link_frame),
        }
    }

    /// A point of link frame i, in the own frame of joint i.
    pub(super) fn leave_point(&self, i: usize, point: Vector3<R>) -> Vector3<R> {
        self.behind[i].leave_point(point)
    }

    /// The parameters of link i and of what is fixed to it, in the own frame of joint i.
    pub(super) fn body<I: Interpretation<Number = R>>(
        &self,
        cells: &mut I,
        arm: &Mechanism,
        i: usize,
    ) -> Body<R> {
        let leave = |body: Central<R>| Body::new(self.behind[i].leave_body(body));
        let own = leave(place::central(cells, &arm.joints[i].body));
        let fixed_bodies = arm.fixed_bodies.iter();
        let here = fixed_bodies.filter(|fixed| fixed.link == i);
        here.fold(own, |own, FixedBody { places, body, .. }| {
            let body = place::central(cells, body);
            own.joined(leave(place(cells, places).leave_body(body)))
        })
    }
}

/// The turn about an axis by the sum of some angles.
pub(super) fn constant_turn<I: Interpretation>(cells: &mut I, angles: &[Value]) -> Turn<I::Number> {
    let angles = angles.iter().map(|angle| Turn::from(cells.sin_cos(angle)));
    angles.reduce(Turn::plus).expect("theta is one of them")
}

/// How a joint moves by a free one: one that moves by itself has the factor 1, and no offset.
#[derive(Clone, Copy)]
pub(crate) struct Moved<R> {
    /// The number of the free joint.
    pub(crate) joint: usize,
    pub(crate) factor: R,
    /// The position of a joint that slides while the free joint is at zero.
    pub(crate) offset: R,
    /// The constant turn about the axis.
    pub(crate) turn: Turn<R>,
}

impl<R: Ring> Moved<R> {
    /// How joint i moves; `None` if it stands still.
    pub(crate) fn of<I>(cells: &mut I, arm: &Mechanism, i: usize) -> Option<Self>
    where
        I: Interpretation<Number = R>,
    {
        let (joint, coupling) = arm.moved_by(i)?;
        let turn = constant_turn(cells, &arm.joints[i].turn);
        let (factor, offset) = match coupling {
            Some(coupling) => (cells.value(&coupling.factor), cells.value(&coupling.offset)),
            None => (
                cells.rational(&Rational::ONE),
                cells.rational(&Rational::ZERO),
            ),
        };
        Some(Moved {
            joint,
            factor,
            offset,
            turn,
        })
    }

    /// The same in other numbers.
    pub(crate) fn map<S>(self, number: impl Fn(R) -> S) -> Moved<S> {
        Moved {
            joint: self.joint,
            factor: number(self.factor),
            offset: number(self.offset),
            turn: self.turn.map(number),
        }
    }
}
