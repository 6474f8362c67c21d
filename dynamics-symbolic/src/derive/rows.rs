//! The constant geometry of a mechanism in any ring: between the axes of joints, and from these to link frames.

use super::place::{self, place};
use crate::exact::Rational;
use crate::linear::{Ring, Vector3};
use crate::mechanism::{Joint, Mechanism};
use crate::robot::{Interpretation, Tool};
use crate::spatial::{Body, Central, Place, Turn};

/// The constant places of an arm.
pub(super) struct Places<R> {
    /// Of each joint's axis, in the frame of the joint before.
    pub(super) before: Vec<Place<R>>,
    /// Of each link frame, in the frame of its joint.
    behind: Vec<Place<R>>,
}

impl<R: Ring> Places<R> {
    /// Reads them.
    pub(super) fn new<I: Interpretation<Number = R>>(cells: &mut I, arm: &Mechanism) -> Self {
        let joints = arm.joints.iter();
        let before = joints.map(|joint| place(cells, &joint.before)).collect();
        let joints = arm.joints.iter();
        let behind = joints.map(|joint| place(cells, &joint.link_frame));
        Places {
            before,
            behind: behind.collect(),
        }
    }

    /// A point of link frame i, in the frame of joint i.
    pub(super) fn leave_point(&self, i: usize, point: Vector3<R>) -> Vector3<R> {
        self.behind[i].leave_point(point)
    }

    /// The parameters of link i and of what is fixed to it, in the frame of joint i.
    pub(super) fn body<I: Interpretation<Number = R>>(
        &self,
        cells: &mut I,
        arm: &Mechanism,
        i: usize,
    ) -> Body<R> {
        let joint = &arm.joints[i];
        let leave = |body: Central<R>| Body::new(self.behind[i].leave_body(body));
        let own = leave(place::central(
            cells,
            &joint.mass,
            &joint.com,
            &joint.inertia,
        ));
        let is_here = |tool: &&Tool| arm.tip == Some(i) && tool.has_body();
        match arm.tool.as_ref().filter(is_here) {
            Some(tool) => own.joined(leave(place::body(cells, tool))),
            None => own,
        }
    }
}

/// The constant turn about a joint's axis.
pub(super) fn constant_turn<I: Interpretation>(cells: &mut I, joint: &Joint) -> Turn<I::Number> {
    let angles = joint
        .turn
        .iter()
        .map(|angle| Turn::from(cells.sin_cos(angle)));
    angles.reduce(Turn::plus).expect("theta is one of them")
}

/// How a joint moves by a free one: one that moves by itself has the factor 1, and no offset.
#[derive(Clone, Copy)]
pub(crate) struct Moved<R> {
    /// The number of the free joint.
    pub(crate) joint: usize,
    pub(crate) factor: R,
    /// Of a joint that slides: where it is while the free joint is at zero.
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
        let turn = constant_turn(cells, &arm.joints[i]);
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
