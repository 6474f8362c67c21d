//! The chain in proximal frames: every frame has its origin and its z axis on
//! the axis of its own joint, whatever the convention of the table.

use super::rows::Places;
use super::symbols::Symbols;
use super::{base, place};
use crate::expr::{Expr, Level};
use crate::linear::{Ring, Symmetric3, Vector3};
use crate::mechanism::{self, Origin, Tree};
use crate::robot::Interpretation;
use crate::spatial::{
    Acceleration, Along, Axis, AxisMotion, Body, Force, Joint, Keep, Motion, Spread, Turn, Writing,
    leave_about,
};
use core::ops::Add;

/// A link in its proximal frame.
#[derive(Clone, Debug)]
pub struct Link<R> {
    /// The joint that moves it.
    pub joint: Joint<R>,
    /// Whether that joint stands still: then the link is a part of the one before, and the turn or the
    /// slide is constant.
    pub stands: bool,
    /// Whether it carries a base that moves: then the link keeps all parameters.
    pub is_of_base: bool,
    /// How its equations are written.
    pub writing: Writing,
    /// Where the origin is on the axis, from that of the joint's own frame.
    pub shift: R,
    /// Turn about z from this frame to the joint's own, which turns with the link.
    pub behind: Turn<R>,
    /// Inertial parameters about the frame's origin.
    pub body: Body<R>,
    /// gear_ratio^2 * motor_inertia.
    pub reflected: R,
}

impl<R: Ring> Link<R> {
    /// A body of the joint's own frame, in this frame.
    pub fn place(&self, body: Body<R>, zero: R) -> Body<R> {
        body.moved(Vector3::new(zero, zero, -self.shift))
            .left(Axis::Z, self.behind)
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
    /// Potential energy of a mass at the origin of frame 0, times -1 and over the mass; zero where that is the
    /// world's origin.
    pub datum: R,
    /// The body that the grouping of parameters left on the base: it matters to the potential energy alone.
    pub base: Body<R>,
    /// The links.
    pub links: Vec<Link<R>>,
    /// Which of them carries which.
    pub(crate) tree: Tree,
    /// The joint about whose origin the moment of a wrench on a frame is taken, where it is about one.
    pub pivot: Option<usize>,
}

/// The numbers of a table from which its chains are built: they are the same in all gauges.
pub(super) struct Given<R> {
    places: Places<R>,
    links: Vec<GivenLink<R>>,
    gravity: Vector3<R>,
    strength: R,
    datum: R,
}

/// The numbers of one link.
struct GivenLink<R> {
    /// The offset along the joint's axis.
    d: R,
    /// The turn about the joint's axis.
    turn: Turn<R>,
    /// Inertial parameters in the joint's own frame, without those that are neglected; none of a part of the base.
    body: Body<R>,
    /// The reflected inertia of its motor, without a part that is neglected.
    reflected: R,
}

impl<'g> Given<Expr<'g>> {
    /// Reads the table of an arm.
    pub(super) fn new(symbols: &mut Symbols<'g>) -> Self {
        let (zero, arm) = (symbols.graph().zero(), symbols.arm());
        let places = Places::new(symbols, arm);
        let neglected = base::neglected(symbols);
        let joints = arm.joints.iter().enumerate();
        let link = |(i, joint): (usize, &mechanism::Joint)| GivenLink {
            d: symbols.value(&joint.aligned.d),
            turn: symbols.turn(i),
            body: if arm.is_of_base(i) {
                Body::splat(zero)
            } else {
                places.body(symbols, arm, i).less(neglected[i].0)
            },
            reflected: base::reflected(symbols, joint) - neglected[i].1,
        };
        let links = joints.map(link).collect();
        Given {
            places,
            links,
            gravity: place::gravity(symbols, arm),
            strength: strength(symbols),
            datum: place::datum(symbols, arm).unwrap_or(zero),
        }
    }
}

impl<'g> Chain<Expr<'g>> {
    /// The chain of an arm, each frame's origin where `origins` says.
    pub(super) fn new(symbols: &Symbols<'g>, given: &Given<Expr<'g>>, origins: &[Origin]) -> Self {
        let (graph, arm) = (symbols.graph(), symbols.arm());
        let (zero, one) = (graph.zero(), graph.one());
        let mut links = Vec::with_capacity(arm.joints.len());
        arm.tree.outward(zero, |i, &shift_before| {
            let (link, shift) = Link::new(symbols, given, (i, origins[i]), shift_before);
            links.push(link);
            shift
        });
        Chain {
            zero,
            one,
            gravity: given.gravity,
            strength: given.strength,
            datum: given.datum,
            base: Body::splat(zero),
            links,
            tree: arm.tree.clone(),
            pivot: None,
        }
    }
}

impl<'g> Link<Expr<'g>> {
    /// Link i, on a link whose origin is at `shift_before` on its axis; and where its own origin is, from that of the
    /// aligned frame.
    fn new(
        symbols: &Symbols<'g>,
        given: &Given<Expr<'g>>,
        (i, origin): (usize, Origin),
        shift_before: Expr<'g>,
    ) -> (Self, Expr<'g>) {
        let (graph, joint) = (symbols.graph(), &symbols.arm().joints[i]);
        let (before, own) = (&given.places.before[i], &given.places.own[i]);
        let zero = graph.zero();
        let GivenLink {
            d,
            turn,
            body,
            reflected,
        } = given.links[i];
        // The origin is at d + shift along the axis.
        let shift = match origin {
            Origin::AfterOffset => zero,
            Origin::BeforeOffset => -d,
        };
        let along = before.turns.leave(Vector3::new(zero, zero, d + shift));
        let offset = along + before.origin.plus_z(-shift_before);
        let slide = match joint.axis_motion {
            AxisMotion::Turns => zero,
            AxisMotion::Slides => symbols.joint(i).q,
        };
        let none = Turn::none(zero, graph.one());
        let turns = own.turns.0.iter().map(|(_, turn)| *turn);
        let moved = body.moved(Vector3::new(zero, zero, own.origin[2] - shift));
        let link = Link {
            joint: Joint {
                zero,
                axis_motion: joint.axis_motion,
                before: none,
                twist: before.turns.clone(),
                turn,
                offset,
                slide,
            },
            stands: joint.stands(),
            is_of_base: joint.is_of_base(),
            writing: Writing::PLAIN,
            shift: shift - own.origin[2],
            behind: turns.fold(none, Turn::plus),
            body: own.turns.leave_body(moved),
            reflected,
        };
        (link, shift)
    }
}

impl<R: Ring> Chain<R> {
    /// Joint i.
    pub(super) fn joint(&self, i: usize) -> &Joint<R> {
        &self.links[i].joint
    }

    /// The axis of joint i in its own frame.
    pub(super) fn axis(&self, i: usize) -> Motion<R> {
        Motion::axis(self.joint(i).axis_motion, self.zero, self.one)
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
        self.tree.outward(base, |i, before| {
            let Link { writing, joint, .. } = &self.links[i];
            writing.accelerate(before, joint, [qd[i], qdd[i]])
        })
    }

    /// The component of a force on link i along every joint that carries the link; zero for the others.
    pub(super) fn joint_forces(&self, i: usize, force: Force<R>) -> Vec<R> {
        let mut forces = vec![self.zero; self.links.len()];
        let leave = |j: usize, force: Force<R>| force.leave(self.joint(j));
        self.tree.along_carriers(i, force, leave, |j, force| {
            forces[j] = force.along(self.joint(j).axis_motion);
        });
        forces
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
    /// axis. A prismatic joint: the whole inertia tensor, for both links turn alike. A joint that
    /// stands still: everything.
    pub fn group_parameters(&mut self, half: R, keep: &[Keep]) {
        let (zero, links) = (self.zero, &mut self.links);
        let none = Body::splat(zero);
        self.base = self.tree.inward(none, Body::joined, |i, outer| {
            let link = &mut links[i];
            let joint = &link.joint;
            let whole = link.body.joined(outer);
            let (moving, rest) = match joint.axis_motion {
                _ if link.is_of_base => (none, whole),
                _ if link.stands => (joint.leave_body(whole), none),
                AxisMotion::Turns => {
                    if keep[i] == Keep::Lamina {
                        link.writing.spread = Spread::Lamina;
                    }
                    let (invariant, rest) = whole.split_revolute([zero, half], keep[i]);
                    (joint.twist.leave_body(invariant).moved(joint.offset), rest)
                }
                AxisMotion::Slides => {
                    let mut tensor = none;
                    tensor.inertia = whole.inertia;
                    let rest = Body {
                        inertia: Symmetric3::splat(zero),
                        ..whole
                    };
                    let turned = tensor.left(Axis::Z, joint.turn);
                    (joint.twist.leave_body(turned), rest)
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
            joint.offset = leave_about(Axis::Z, behind, joint.offset);
            let is_none = |turn: &Turn<Expr<'_>>| turn.s.is_zero() && turn.c == one;
            let is_parallel = joint.twist.0.iter().all(|(_, turn)| is_none(turn));
            (joint.before, joint.turn) = if is_parallel {
                // Rz(behind) Rz(turn): one turn about the common direction.
                (none, behind.plus(joint.turn))
            } else {
                (behind, joint.turn)
            };
            if !stays[i] || joint.axis_motion != AxisMotion::Turns {
                return none;
            }
            let turn = core::mem::replace(&mut joint.turn, none);
            link.behind = turn.plus(link.behind);
            link.body = link.body.left(Axis::Z, turn);
            if link.writing.spread == Spread::Lamina {
                link.writing.spread = Spread::TurningLamina;
            }
            turn
        });
    }

    /// Lets links for which `turns` holds turn U times the axis of their joint in place of their angular acceleration, if
    /// they turn about an axis of the frame before.
    pub fn turn_columns(&mut self, turns: &[bool]) {
        let z = Vector3::new(self.zero, self.zero, self.one);
        for (link, turns) in self.links.iter_mut().zip(turns) {
            if *turns && link.joint.axis_motion == AxisMotion::Turns {
                link.writing.along = along(link.joint.leave(z), self.one);
            }
        }
    }
}

/// The coordinate axis along which a unit vector is, if it is along one.
fn along<'g>(v: Vector3<Expr<'g>>, one: Expr<'g>) -> Option<Along> {
    let components = v.0.iter().enumerate();
    let mut others = components.filter(|(_, x)| !x.is_zero());
    let (axis, x) = others.next()?;
    others.next().is_none().then(|| Along {
        axis,
        is_opposite: *x != one,
    })
}

/// See [`Chain::strength`]. Seen from a base that is turned, a component may be a number that happens
/// to be zero, such as sin 30 deg - 1/2: no quotient is made of it.
fn strength<'g>(symbols: &mut Symbols<'g>) -> Expr<'g> {
    let arm = symbols.arm();
    let is_number = |g: &Expr<'g>| g.level() == Level::Constant && !g.is_zero();
    let components = arm.gravity.each_ref().map(|g| symbols.value(g));
    let number = components.into_iter().rev().find(is_number);
    number.unwrap_or(symbols.graph().one())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Residue, SplitMix64, circle_point};
    use crate::spatial::Turns;

    type Number = Residue<{ (1 << 61) - 1 }>;

    fn vector(random: &mut SplitMix64) -> Vector3<Number> {
        Vector3([(); 3].map(|()| Number::random(random)))
    }

    fn turn(random: &mut SplitMix64) -> Turn<Number> {
        Turn::from(circle_point(random))
    }

    fn link(axis_motion: AxisMotion, random: &mut SplitMix64) -> Link<Number> {
        Link {
            joint: Joint {
                zero: Number::ZERO,
                axis_motion,
                before: turn(random),
                twist: Turns(vec![(Axis::X, turn(random))]),
                turn: turn(random),
                offset: vector(random),
                slide: Number::random(random),
            },
            stands: false,
            is_of_base: false,
            writing: Writing::PLAIN,
            shift: Number::ZERO,
            behind: Turn::none(Number::ZERO, Number::ONE),
            body: Body::splat(Number::ZERO),
            reflected: Number::ZERO,
        }
    }

    /// The component along a joint is the power of the force in a unit velocity of the joint: on a branch that does
    /// not carry the link, zero.
    #[test]
    fn joint_forces_are_the_power_of_a_force() {
        use AxisMotion::{Slides, Turns};
        let random = &mut SplitMix64::new(3);
        let motions = [Turns, Slides, Slides, Turns];
        let chain = Chain {
            zero: Number::ZERO,
            one: Number::ONE,
            gravity: vector(random),
            strength: Number::ONE,
            datum: Number::ZERO,
            base: Body::splat(Number::ZERO),
            links: motions.map(|axis_motion| link(axis_motion, random)).into(),
            tree: Tree::new(vec![None, Some(0), Some(0), Some(1)]),
            pivot: None,
        };
        let force = Force {
            n: vector(random),
            f: vector(random),
        };
        let forces = chain.joint_forces(3, force);
        for (i, axis) in &chain.axes()[3] {
            assert_eq!(forces[*i], axis.dot(force));
        }
        assert_eq!((forces[2], chain.axes()[3].len()), (Number::ZERO, 3));
    }
}
