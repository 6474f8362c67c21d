//! The chain in proximal frames: every frame has its origin and its z axis on
//! the axis of its own joint, whatever the convention of the table.

use super::rows::{body, screws};
use super::symbols::Symbols;
use super::{base, place};
use crate::expr::{Expr, Level};
use crate::linear::{Ring, Symmetric3, Vector3};
use crate::robot::{Interpretation, JointType, Robot};
use crate::spatial::{Body, Joint, Keep, Motion, Turn, leave_x, leave_z};

/// Where the origin of a joint's frame is on the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Origin {
    /// After the offset d: at the common normal with the next axis.
    AfterOffset,
    /// Before the offset d: at the common normal with the previous axis.
    BeforeOffset,
}

/// A link in its proximal frame.
#[derive(Clone, Copy, Debug)]
pub struct Link<R> {
    /// The joint that moves it.
    pub joint: Joint<R>,
    /// Whether that joint is locked: then the link is a part of the one before, and the turn or the
    /// slide is constant.
    pub locked: bool,
    /// Where the origin is on the axis, from the place after the offset d.
    pub shift: R,
    /// Turn about z from this frame to the link, where the frame stays behind the joint.
    pub behind: Turn<R>,
    /// Inertial parameters about the frame's origin.
    pub body: Body<R>,
    /// gear_ratio^2 * motor_inertia.
    pub reflected: R,
}

impl<R: Ring> Link<R> {
    /// A body of the frame that turns with the link, its origin after the offset d, in this frame.
    pub fn place(&self, body: Body<R>, zero: R) -> Body<R> {
        body.moved(Vector3::new(zero, zero, -self.shift))
            .left_z(self.behind)
    }
}

/// A robot in proximal frames.
pub struct Chain<R> {
    /// Zero.
    pub zero: R,
    /// One.
    pub one: R,
    /// Acceleration of gravity in the axes of frame 0.
    pub gravity: Vector3<R>,
    /// A number of the table's gravity that is not zero, where there is one, else 1.
    pub strength: R,
    /// What a mass at the origin of frame 0 has of potential energy, times -1 and over the mass; zero
    /// where that is the world's origin.
    pub datum: R,
    /// What the grouping of parameters left on the base: it matters to the potential energy alone.
    pub base: Body<R>,
    /// The links.
    pub links: Vec<Link<R>>,
    /// The joint about whose origin the moment of a wrench on the tip is told, where it is about one.
    pub pivot: Option<usize>,
}

impl<'g> Chain<Expr<'g>> {
    /// The chain of a robot, each frame's origin where `origins` says.
    pub fn new(symbols: &mut Symbols<'g>, robot: &Robot, origins: &[Origin]) -> Self {
        let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
        let none = Turn::none(zero, one);
        let screws = screws(symbols, robot);
        let mut previous_shift = zero;
        let links_of_base = robot.links_of_base();
        let neglected = base::neglected(symbols, robot);
        let links = robot.rows.iter().enumerate().map(|(i, row)| {
            let d = symbols.value(&row.d);
            // The origin is at d + shift along the axis.
            let shift = match origins[i] {
                Origin::AfterOffset => zero,
                Origin::BeforeOffset => -d,
            };
            let screw = &screws[i];
            let along = leave_x(screw.turn, Vector3::new(zero, zero, d + shift));
            let offset = along + Vector3::new(screw.a, zero, -previous_shift);
            previous_shift = shift;
            let (s, c) = symbols.joint_sin_cos(i, row.joint_type, &row.theta);
            let slide = match row.joint_type {
                JointType::Revolute => zero,
                JointType::Prismatic => symbols.joint(i).q,
            };
            let body = match i < links_of_base {
                true => Body::splat(zero),
                false => body(symbols, robot, i, &screws[i + 1])
                    .less(neglected[i].0)
                    .moved(Vector3::new(zero, zero, -shift)),
            };
            let ratio = symbols.value(&row.gear_ratio);
            let reflected = match row.locked {
                None => ratio * ratio * symbols.value(&row.motor_inertia) - neglected[i].1,
                Some(_) => zero,
            };
            Link {
                joint: Joint {
                    joint_type: row.joint_type,
                    before: none,
                    twist: screw.turn,
                    turn: Turn { s, c },
                    offset,
                    slide,
                },
                locked: row.locked.is_some(),
                shift,
                behind: none,
                body,
                reflected,
            }
        });
        let links = links.collect();
        let gravity = place::gravity(symbols, robot);
        Chain {
            zero,
            one,
            gravity,
            strength: strength(symbols, robot),
            datum: place::datum(symbols, robot).unwrap_or(zero),
            base: Body::splat(zero),
            links,
            pivot: None,
        }
    }
}

impl<R: Ring> Chain<R> {
    /// The joints from the base outwards.
    pub fn joints(&self) -> impl DoubleEndedIterator<Item = &Joint<R>> + ExactSizeIterator {
        self.links.iter().map(|link| &link.joint)
    }

    /// The axes of joints 0 to m in frame m, for every m.
    pub(super) fn axes(&self) -> Vec<Vec<Motion<R>>> {
        let mut axes: Vec<Vec<Motion<R>>> = Vec::with_capacity(self.links.len());
        for joint in self.joints() {
            let inner = axes.last().into_iter().flatten();
            let mut row: Vec<_> = inner.map(|axis| axis.enter(joint)).collect();
            row.push(Motion::axis(joint.joint_type, self.zero, self.one));
            axes.push(row);
        }
        axes
    }

    /// Moves to the previous link what a joint cannot tell apart: base inertial
    /// parameters by the rules of Gautier and Khalil (1990).
    ///
    /// A revolute joint: the part that is invariant under rotation about its
    /// axis. A prismatic joint: the whole inertia tensor, for both links turn alike. A joint that is
    /// locked: everything.
    pub fn group_parameters(&mut self, keep: &[Keep]) {
        for i in (0..self.links.len()).rev() {
            let link = self.links[i];
            let joint = &link.joint;
            let (moving, rest) = match joint.joint_type {
                _ if link.locked => (joint.leave_body(link.body), Body::splat(self.zero)),
                JointType::Revolute => {
                    let (invariant, rest) = link.body.split_revolute(self.zero, keep[i]);
                    (invariant.left_x(joint.twist).moved(joint.offset), rest)
                }
                JointType::Prismatic => {
                    let mut tensor = Body::splat(self.zero);
                    tensor.inertia = link.body.inertia;
                    let rest = Body {
                        inertia: Symmetric3::splat(self.zero),
                        ..link.body
                    };
                    (tensor.left_z(joint.turn).left_x(joint.twist), rest)
                }
            };
            self.links[i].body = rest;
            let previous = match i {
                0 => &mut self.base,
                _ => &mut self.links[i - 1].body,
            };
            *previous = previous.joined(moving);
        }
    }
}

impl Chain<Expr<'_>> {
    /// Lets frames stay behind their joints: where `stays` holds, frame i keeps
    /// the orientation that it has before joint i turns, and the link's
    /// parameters turn in it. Between parallel axes the frames that stay behind
    /// are all alike, and angles add up: sin and cos of q2 + q3 from those of
    /// q2 and q3.
    pub fn stay_behind(&mut self, stays: &[bool]) {
        let none = Turn::none(self.zero, self.one);
        let mut turned = none;
        for (link, &stays) in self.links.iter_mut().zip(stays) {
            let joint = &mut link.joint;
            joint.offset = leave_z(turned, joint.offset);
            let is_parallel = joint.twist.s.is_zero() && joint.twist.c == self.one;
            if is_parallel {
                // Rz(turned) Rz(turn): one turn about the common direction.
                joint.turn = turned.plus(joint.turn);
                turned = none;
            }
            joint.before = turned;
            turned = none;
            if stays && joint.joint_type == JointType::Revolute {
                turned = joint.turn;
                joint.turn = none;
                link.behind = turned;
                link.body = link.body.left_z(turned);
            }
        }
    }
}

/// See [`Chain::strength`]. Seen from a base that is turned, a component may be a number that happens
/// to be zero, such as sin 30 deg - 1/2: no quotient is made of it.
fn strength<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Expr<'g> {
    let is_number = |g: &Expr<'g>| g.level() == Level::Constant && !g.is_zero();
    let components = robot.gravity.each_ref().map(|g| symbols.value(g));
    let number = components.into_iter().rev().find(is_number);
    number.unwrap_or(symbols.graph().one())
}
