//! The chain in proximal frames: every frame has its origin and its z axis on
//! the axis of its own joint, whatever the convention of the table.

use super::rows::{body, screws};
use super::symbols::Symbols;
use super::walk::Tree;
use super::{base, place};
use crate::expr::{Expr, Level};
use crate::linear::{Ring, Symmetric3, Vector3};
use crate::robot::{Interpretation, JointType, Robot};
use crate::spatial::{Acceleration, Body, Force, Joint, Keep, Motion, Turn, leave_x, leave_z};
use core::ops::Add;

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
    /// Which of them carries which.
    pub(crate) tree: Tree,
    /// The joint about whose origin the moment of a wrench on the tip is told, where it is about one.
    pub pivot: Option<usize>,
}

impl<'g> Chain<Expr<'g>> {
    /// The chain of a robot, each frame's origin where `origins` says.
    pub fn new(symbols: &mut Symbols<'g>, robot: &Robot, origins: &[Origin]) -> Self {
        let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
        let none = Turn::none(zero, one);
        let screws = screws(symbols, robot);
        let tree = Tree::of(robot);
        let links_of_base = robot.links_of_base();
        let neglected = base::neglected(symbols, robot);
        let mut links: Vec<Link<Expr<'g>>> = Vec::with_capacity(robot.rows.len());
        for (i, row) in robot.rows.iter().enumerate() {
            let shift_before = tree.parent(i).map_or(zero, |parent| links[parent].shift);
            let d = symbols.value(&row.d);
            // The origin is at d + shift along the axis.
            let shift = match origins[i] {
                Origin::AfterOffset => zero,
                Origin::BeforeOffset => -d,
            };
            let screw = &screws[i];
            let along = leave_x(screw.turn, Vector3::new(zero, zero, d + shift));
            let offset = along + Vector3::new(screw.a, zero, -shift_before);
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
            links.push(Link {
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
            });
        }
        let gravity = place::gravity(symbols, robot);
        Chain {
            zero,
            one,
            gravity,
            strength: strength(symbols, robot),
            datum: place::datum(symbols, robot).unwrap_or(zero),
            base: Body::splat(zero),
            links,
            tree,
            pivot: None,
        }
    }
}

impl<R: Ring> Chain<R> {
    /// Joint i.
    pub(super) fn joint(&self, i: usize) -> &Joint<R> {
        &self.links[i].joint
    }

    /// The axis of joint i in its own frame.
    pub(super) fn axis(&self, i: usize) -> Motion<R> {
        Motion::axis(self.joint(i).joint_type, self.zero, self.one)
    }

    /// The joints that carry the tip, from its own link's inwards.
    pub(super) fn carriers_of_tip(&self) -> impl Iterator<Item = usize> {
        let last = self.links.len().checked_sub(1);
        last.into_iter().flat_map(|last| self.tree.carriers(last))
    }

    /// For every link the axes of the joints that carry it, in its frame, each with the number of the joint.
    pub(super) fn axes(&self) -> Vec<Vec<(usize, Motion<R>)>> {
        let enter = |i: usize, axis: &Motion<R>| axis.enter(self.joint(i));
        self.tree.of_carriers(|i| self.axis(i), enter)
    }

    /// How all links move, on a base that accelerates against gravity.
    pub(super) fn accelerations(
        &self,
        gravity: Vector3<R>,
        qd: &[R],
        qdd: &[R],
    ) -> Vec<Acceleration<R>> {
        let base = Acceleration::of_base(self.zero, gravity);
        self.tree
            .outward(base, |i, before| before.enter(self.joint(i), qd[i], qdd[i]))
    }

    /// For every joint what it feels of a force on link i: all of it, if the joint carries the link.
    pub(super) fn felt(&self, i: usize, force: Force<R>) -> Vec<R> {
        let mut felt = vec![self.zero; self.links.len()];
        let leave = |j: usize, force: Force<R>| force.leave(self.joint(j));
        self.tree.along_carriers(i, force, leave, |j, force| {
            felt[j] = force.along(self.joint(j).joint_type);
        });
        felt
    }

    /// From the tips inwards, forces: `step(i, outer)` makes of what reaches link i from the links outside it the
    /// force that joint i supplies to it, which is handed on to the link before.
    pub(super) fn forces_inward(&self, mut step: impl FnMut(usize, Force<R>) -> Force<R>) {
        let none = Force::splat(self.zero);
        self.tree.inward(none, Force::add, |i, outer| {
            step(i, outer).leave(self.joint(i))
        });
    }

    /// Moves to the previous link what a joint cannot tell apart: base inertial
    /// parameters by the rules of Gautier and Khalil (1990).
    ///
    /// A revolute joint: the part that is invariant under rotation about its
    /// axis. A prismatic joint: the whole inertia tensor, for both links turn alike. A joint that is
    /// locked: everything.
    pub fn group_parameters(&mut self, keep: &[Keep]) {
        let (zero, links) = (self.zero, &mut self.links);
        let none = Body::splat(zero);
        self.base = self.tree.inward(none, Body::joined, |i, outer| {
            let link = &mut links[i];
            let joint = &link.joint;
            let whole = link.body.joined(outer);
            let (moving, rest) = match joint.joint_type {
                _ if link.locked => (joint.leave_body(whole), none),
                JointType::Revolute => {
                    let (invariant, rest) = whole.split_revolute(zero, keep[i]);
                    (invariant.left_x(joint.twist).moved(joint.offset), rest)
                }
                JointType::Prismatic => {
                    let mut tensor = none;
                    tensor.inertia = whole.inertia;
                    let rest = Body {
                        inertia: Symmetric3::splat(zero),
                        ..whole
                    };
                    (tensor.left_z(joint.turn).left_x(joint.twist), rest)
                }
            };
            link.body = rest;
            moving
        });
    }
}

impl Chain<Expr<'_>> {
    /// Lets frames stay behind their joints: where `stays` holds, frame i keeps
    /// the orientation that it has before joint i turns, and the link's
    /// parameters turn in it. Between parallel axes the frames that stay behind
    /// are all alike, and angles add up: sin and cos of q2 + q3 from those of
    /// q2 and q3.
    pub fn stay_behind(&mut self, stays: &[bool]) {
        let (one, links) = (self.one, &mut self.links);
        let none = Turn::none(self.zero, one);
        self.tree.outward(none, |i, &behind| {
            let link = &mut links[i];
            let joint = &mut link.joint;
            joint.offset = leave_z(behind, joint.offset);
            let is_parallel = joint.twist.s.is_zero() && joint.twist.c == one;
            (joint.before, joint.turn) = if is_parallel {
                // Rz(behind) Rz(turn): one turn about the common direction.
                (none, behind.plus(joint.turn))
            } else {
                (behind, joint.turn)
            };
            if stays[i] && joint.joint_type == JointType::Revolute {
                link.behind = joint.turn;
                joint.turn = none;
                link.body = link.body.left_z(link.behind);
            }
            link.behind
        });
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Residue, SplitMix64, circle_point};

    type Number = Residue<{ (1 << 61) - 1 }>;

    fn vector(random: &mut SplitMix64) -> Vector3<Number> {
        Vector3([(); 3].map(|()| Number::random(random)))
    }

    fn turn(random: &mut SplitMix64) -> Turn<Number> {
        Turn::from(circle_point(random))
    }

    fn link(joint_type: JointType, random: &mut SplitMix64) -> Link<Number> {
        Link {
            joint: Joint {
                joint_type,
                before: turn(random),
                twist: turn(random),
                turn: turn(random),
                offset: vector(random),
                slide: Number::random(random),
            },
            locked: false,
            shift: Number::ZERO,
            behind: Turn::none(Number::ZERO, Number::ONE),
            body: Body::splat(Number::ZERO),
            reflected: Number::ZERO,
        }
    }

    /// What a joint feels is the power of the force in a unit velocity of the joint: on a branch that does not carry
    /// the link, nothing.
    #[test]
    fn joints_feel_the_power_of_a_force() {
        use JointType::{Prismatic, Revolute};
        let random = &mut SplitMix64::new(3);
        let types = [Revolute, Prismatic, Prismatic, Revolute];
        let chain = Chain {
            zero: Number::ZERO,
            one: Number::ONE,
            gravity: vector(random),
            strength: Number::ONE,
            datum: Number::ZERO,
            base: Body::splat(Number::ZERO),
            links: types.map(|joint_type| link(joint_type, random)).into(),
            tree: Tree::new(vec![None, Some(0), Some(0), Some(1)]),
            pivot: None,
        };
        let force = Force {
            n: vector(random),
            f: vector(random),
        };
        let felt = chain.felt(3, force);
        for (i, axis) in &chain.axes()[3] {
            assert_eq!(felt[*i], axis.dot(force));
        }
        assert_eq!((felt[2], chain.axes()[3].len()), (Number::ZERO, 3));
    }
}
