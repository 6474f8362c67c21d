//! The constant geometry of a mechanism in any ring: between the axes of joints, and from these to link frames.

use super::place::{self, Placed};
use crate::exact::Rational;
use crate::linear::{Ring, Vector3};
use crate::mechanism::{self, Joint, Mechanism};
use crate::robot::Interpretation;
use crate::spatial::{Body, Central, Turn, leave_x, tensor_leave_x};

/// A step along x and a turn about it.
#[derive(Clone, Copy)]
pub(super) struct Screw<R> {
    pub(super) a: R,
    pub(super) turn: Turn<R>,
}

/// The screws of an arm.
pub(super) struct Screws<R> {
    /// Those before the joints.
    pub(super) before: Vec<Screw<R>>,
    /// Those from the joints to the link frames, where these are placed so.
    behind: Vec<Option<Screw<R>>>,
}

impl<R: Ring> Screws<R> {
    /// Reads them.
    pub(super) fn new<I: Interpretation<Number = R>>(cells: &mut I, arm: &Mechanism) -> Self {
        let joints = || arm.joints.iter();
        let mut screw = |screw: &mechanism::Screw| {
            let turn = Turn::from(cells.sin_cos(&screw.alpha));
            Screw {
                a: cells.value(&screw.a),
                turn,
            }
        };
        Screws {
            before: joints().map(|joint| screw(&joint.before)).collect(),
            behind: joints()
                .map(|joint| joint.link_frame.screw().map(&mut screw))
                .collect(),
        }
    }

    /// A point of link frame i, in the frame of joint i.
    pub(super) fn leave_point<I: Interpretation<Number = R>>(
        &self,
        cells: &mut I,
        arm: &Mechanism,
        i: usize,
        point: Vector3<R>,
    ) -> Vector3<R> {
        let places = placed(cells, &arm.joints[i]).into_iter().rev();
        let point = places.fold(point, |point, place| place.leave_point(point));
        match self.behind[i] {
            Some(screw) => along_x(cells, screw.a) + leave_x(screw.turn, point),
            None => point,
        }
    }

    /// A body of link frame i, in the frame of joint i.
    fn leave_body<I: Interpretation<Number = R>>(
        &self,
        cells: &mut I,
        arm: &Mechanism,
        i: usize,
        body: Central<R>,
    ) -> Body<R> {
        let places = placed(cells, &arm.joints[i]).into_iter().rev();
        let body = places.fold(body, |body: Central<R>, place: Placed<R>| {
            place.leave_body(body)
        });
        Body::new(match self.behind[i] {
            Some(screw) => {
                let inertia = tensor_leave_x(screw.turn, body.inertia);
                let com = leave_x(screw.turn, body.com) + along_x(cells, screw.a);
                Central {
                    inertia,
                    com,
                    ..body
                }
            }
            None => body,
        })
    }

    /// The parameters of link i and of what is fixed to it, in the frame of joint i.
    pub(super) fn body<I: Interpretation<Number = R>>(
        &self,
        cells: &mut I,
        arm: &Mechanism,
        i: usize,
    ) -> Body<R> {
        let joint = &arm.joints[i];
        let own = place::central(cells, &joint.mass, &joint.com, &joint.inertia);
        let own = self.leave_body(cells, arm, i, own);
        let tool = arm
            .tool
            .as_ref()
            .filter(|tool| arm.tip == Some(i) && tool.has_body());
        match tool {
            Some(tool) => {
                let tool = place::body(cells, tool);
                own.joined(self.leave_body(cells, arm, i, tool))
            }
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

/// The places of a link frame, from the outermost on.
fn placed<I: Interpretation>(cells: &mut I, joint: &Joint) -> Vec<Placed<I::Number>> {
    let places = joint.link_frame.places().iter();
    places.map(|place| Placed::new(cells, place)).collect()
}

fn along_x<I: Interpretation>(cells: &mut I, a: I::Number) -> Vector3<I::Number> {
    let zero = cells.rational(&Rational::ZERO);
    Vector3::new(a, zero, zero)
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
