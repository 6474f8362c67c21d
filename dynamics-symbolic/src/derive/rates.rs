//! The first and the second derivative of the joint forces along a motion.
//!
//! Every quantity of the equations of motion is carried as a jet: its value and its first two
//! derivatives by time, with the product rule for products. A turn is no product of two jets, though:
//! with y = E x and a derivative of E that is q' Z E, Z y = y x z on the way outwards and z x y inwards,
//!
//!   y' = E x' + q' Z y,   y'' = E x'' + q' Z (E x' + y') + q'' Z y,
//!
//! so that only E x, E x' and E x'' are turned.

use super::chain::{Chain, Link};
use super::symbols::Symbols;
use crate::expr::{Direction, Expr};
use crate::linear::{Symmetric3, Vector3};
use crate::mechanism::BaseRate;
use crate::operators::impl_operators;
use crate::robot::Interpretation;
use crate::spatial::{
    Acceleration, Axis, AxisMotion, Body, Force, Turn, Turns, Writing, enter_about, leave_about,
};
use core::ops::Add;

/// A value and its first two derivatives by time.
#[derive(Clone, Copy)]
struct Jet<'g>([Expr<'g>; 3]);

type Vector<'g> = Vector3<Jet<'g>>;
type Components<'g> = [Vector3<Expr<'g>>; 3];

impl_operators! {
    impl ['g] for Jet<'g>;
    Add add |a, b| Jet([0, 1, 2].map(|k| a.0[k] + b.0[k]));
    Sub sub |a, b| Jet([0, 1, 2].map(|k| a.0[k] - b.0[k]));
    Neg neg |a| Jet(a.0.map(|x| -x));
    /// (x y)'' = x'' y + 2 x' y' + x y''
    Mul mul |a, b| {
        let ([x, xd, xdd], [y, yd, ydd]) = (a.0, b.0);
        let mixed = xd * yd;
        Jet([x * y, x * yd + xd * y, (x * ydd + xdd * y) + (mixed + mixed)])
    };
}

/// A turn about z whose angle changes: its rate and the rate of that.
#[derive(Clone, Copy)]
struct Turning<'g> {
    turn: Turn<Expr<'g>>,
    rates: [Expr<'g>; 2],
    zero: Expr<'g>,
}

impl<'g> Turning<'g> {
    fn new(turn: Turn<Expr<'g>>, along: &Direction<'g>, zero: Expr<'g>) -> Self {
        // The rate of an angle by its sine and cosine. A node is known by its value: this one is the sum
        // of the velocities of the joints that turn, which stands in the graph before.
        let rate = turn.c * turn.s.derivative(along) - turn.s * turn.c.derivative(along);
        Turning {
            turn,
            rates: [rate, rate.derivative(along)],
            zero,
        }
    }

    fn enter(&self, v: Vector<'g>) -> Vector<'g> {
        self.turned(
            components(v).map(|x| enter_about(Axis::Z, self.turn, x)),
            |y| [y[1], -y[0]],
        )
    }

    fn leave(&self, v: Vector<'g>) -> Vector<'g> {
        self.turned(
            components(v).map(|x| leave_about(Axis::Z, self.turn, x)),
            |y| [-y[1], y[0]],
        )
    }

    /// The jet whose values and derivatives are turned already, in the plane of the turn by Z.
    fn turned(
        &self,
        [y, first, second]: Components<'g>,
        z: impl Fn(Vector3<Expr<'g>>) -> [Expr<'g>; 2],
    ) -> Vector<'g> {
        let [rate, rate_of_rate] = self.rates;
        let plus = |v: Vector3<Expr<'g>>, k: Expr<'g>, of: Vector3<Expr<'g>>| {
            let [zx, zy] = z(of);
            Vector3::new(v[0] + k * zx, v[1] + k * zy, v[2])
        };
        let yd = plus(first, rate, y);
        let ydd = plus(plus(second, rate, first + yd), rate_of_rate, y);
        jet([y, yd, ydd])
    }
}

fn components<'g>(v: Vector<'g>) -> Components<'g> {
    [0, 1, 2].map(|k| Vector3(v.0.map(|jet| jet.0[k])))
}

fn jet<'g>([x, xd, xdd]: Components<'g>) -> Vector<'g> {
    Vector3([0, 1, 2].map(|i| Jet([x[i], xd[i], xdd[i]])))
}

/// A link whose joint moves.
struct Moving<'g> {
    axis_motion: AxisMotion,
    before: Turning<'g>,
    twist: Turns<Expr<'g>>,
    turn: Turning<'g>,
    position: Vector<'g>,
    writing: Writing,
    body: Body<Jet<'g>>,
    reflected: Expr<'g>,
}

impl<'g> Moving<'g> {
    fn enter(&self, v: Vector<'g>) -> Vector<'g> {
        let before = components(self.before.enter(v));
        self.turn.enter(jet(before.map(|x| self.twist.enter(x))))
    }

    fn leave(&self, v: Vector<'g>) -> Vector<'g> {
        let turned = components(self.turn.leave(v));
        self.before.leave(jet(turned.map(|x| self.twist.leave(x))))
    }

    /// The acceleration of the link, from that of the one before.
    fn accelerate(
        &self,
        previous: &Acceleration<Jet<'g>>,
        qd: Jet<'g>,
        qdd: Jet<'g>,
    ) -> Acceleration<Jet<'g>> {
        let (u, w) = (previous.u(), self.enter(previous.w));
        let a = self.enter(previous.a + u.apply(self.position));
        let Some(along) = self.writing.along else {
            let wd = self.enter(previous.wd);
            return Acceleration { w, wd, a }.with_joint(self.axis_motion, qd, qdd);
        };
        let column = self.enter(along.signed(u.column(along.axis)));
        let zd = along.signed(previous.wd[along.axis]) + qdd;
        Acceleration::of_column(column, w.plus_z(qd), zd, a)
    }

    fn hand_on(&self, force: Force<Jet<'g>>) -> Force<Jet<'g>> {
        let f = self.leave(force.f);
        Force {
            n: self.leave(force.n) + self.position.cross(f),
            f,
        }
    }
}

/// The variables of each joint along the motion.
struct Course<'g> {
    along: Direction<'g>,
    qd: Vec<Jet<'g>>,
    qdd: Vec<Jet<'g>>,
}

/// The first derivatives of all joint forces along the motion, then the second ones, without friction.
pub(super) fn recursion<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    [jerk, snap]: [&[Expr<'g>]; 2],
) -> [Vec<Expr<'g>>; 2] {
    let (qd, rate) = (
        symbols.all(|joint| joint.qd),
        symbols.all(|joint| joint.rate),
    );
    let mut course = Course {
        along: along_motion(symbols, [jerk, snap]),
        qd: (0..qd.len())
            .map(|i| Jet([qd[i], rate[i], jerk[i]]))
            .collect(),
        qdd: (0..qd.len())
            .map(|i| Jet([rate[i], jerk[i], snap[i]]))
            .collect(),
    };
    if symbols.arm().freedoms().has_base() {
        let velocity = core::array::from_fn(|k| course.qd[k]);
        let added = BaseRate([3, 4, 5].map(|k| course.qd[k])).times(velocity);
        for (qdd, added) in course.qdd.iter_mut().zip(added) {
            *qdd = *qdd + added;
        }
    }
    note_sums(&qd);
    let links = moving_links(chain, &course.along);
    let forces = forces(chain, &links, &course);
    [1, 2].map(|k| forces.iter().map(|force| force.0[k]).collect())
}

/// Forces that are given as expressions, differentiated on the graph.
pub(super) fn differentiated<'g>(
    symbols: &mut Symbols<'g>,
    forces: &[Expr<'g>],
    rates: [&[Expr<'g>]; 2],
) -> [Vec<Expr<'g>>; 2] {
    let along = along_motion(symbols, rates);
    let derivatives =
        |of: &[Expr<'g>]| -> Vec<_> { of.iter().map(|force| force.derivative(&along)).collect() };
    let first = derivatives(forces);
    let second = derivatives(&first);
    [first, second]
}

/// The motion as a direction: how q, qd, qdd and the jerk change.
fn along_motion<'g>(symbols: &mut Symbols<'g>, [jerk, snap]: [&[Expr<'g>]; 2]) -> Direction<'g> {
    let mut along = motion_of_base(symbols);
    for (i, (&jerk, &snap)) in jerk.iter().zip(snap).enumerate() {
        let (joint, own) = (*symbols.joint(i), &symbols.arm().joints[i].forces);
        if joint.qd.is_zero() {
            continue;
        }
        along = symbols.along_position(along, i, joint.qd);
        along = along
            .with(joint.qd, joint.rate)
            .with(joint.rate, jerk)
            .with(jerk, snap);
        if let (Some(stribeck), Some(left)) = (&own.stribeck, joint.stribeck) {
            // exp(-(qd/v)^2)' = -2 qd qdd/v^2 exp(-(qd/v)^2)
            let v = symbols.value(&stribeck.velocity);
            let slope = (joint.qd + joint.qd) / (v * v);
            along = along.with(left, -(slope * joint.qdd * left));
        }
    }
    along
}

/// How the rotation R and the position p of a base that moves change: R' = R [w]x and p' = R v.
fn motion_of_base<'g>(symbols: &mut Symbols<'g>) -> Direction<'g> {
    let mut along = Direction::new();
    let Some((rotation, position)) = symbols.pose_of_base() else {
        return along;
    };
    let of_joints = |first: usize| Vector3([0, 1, 2].map(|k| symbols.joint(first + k).qd));
    let (v, w) = (of_joints(0), of_joints(3));
    for (row, p) in rotation.into_iter().zip(position) {
        let row = Vector3(row);
        along = along.with(p, row.dot(v));
        for (entry, rate) in row.0.into_iter().zip(row.cross(w).0) {
            along = along.with(entry, rate);
        }
    }
    along
}

/// The velocities of joints whose axes are parallel add up: makes the sums of all neighbours.
fn note_sums(qd: &[Expr<'_>]) {
    for first in 0..qd.len() {
        let rest = &qd[first + 1..];
        rest.iter().fold(qd[first], |sum, &qd| sum + qd);
    }
}

fn moving_links<'g>(chain: &Chain<Expr<'g>>, along: &Direction<'g>) -> Vec<Moving<'g>> {
    let turning = |turn| Turning::new(turn, along, chain.zero);
    let mut links = Vec::with_capacity(chain.links.len());
    // A frame that stays behind its link turns on it, and what is constant on the link turns in it.
    let base = turning(Turn::none(chain.zero, chain.one));
    chain.tree.outward(base, |i, frame_before| {
        let (link, joint) = (&chain.links[i], chain.joint(i));
        let before = turning(joint.before);
        let offset = frame_before.spun(joint.offset);
        let frame = turning(link.behind);
        links.push(Moving {
            axis_motion: joint.axis_motion,
            before,
            twist: joint.twist.clone(),
            turn: turning(joint.turn),
            position: offset + before.leave(slide(chain, link, along)),
            body: body(chain, link, &frame),
            writing: link.writing,
            reflected: link.reflected,
        });
        frame
    });
    links
}

/// How far the joint has slid, in the axes behind the turn about x.
fn slide<'g>(chain: &Chain<Expr<'g>>, link: &Link<Expr<'g>>, along: &Direction<'g>) -> Vector<'g> {
    let twist = &link.joint.twist;
    let speed = link.joint.slide.derivative(along);
    let slides = [link.joint.slide, speed, speed.derivative(along)];
    jet(slides.map(|x| twist.leave(Vector3::new(chain.zero, chain.zero, x))))
}

impl<'g> Turning<'g> {
    /// A vector that this turn has turned: v' = q' z x v, v'' = q'' z x v + q'^2 z x (z x v).
    fn spun(&self, v: Vector3<Expr<'g>>) -> Vector<'g> {
        let none = Vector3::splat(self.zero);
        self.turned([v, none, none], |y| [-y[1], y[0]])
    }

    /// The same for a tensor J: J' = q' K(J), J'' = q'' K(J) + q'^2 K(K(J)) with K(J) = [z]x J - J [z]x.
    fn spun_tensor(&self, j: Symmetric3<Expr<'g>>) -> Symmetric3<Jet<'g>> {
        let [rate, rate_of_rate] = self.rates;
        let slope = j.slope_about_z(self.zero);
        let first = slope * rate;
        let second = slope * rate_of_rate + slope.slope_about_z(self.zero) * (rate * rate);
        let [j, first, second] = [j, first, second].map(|tensor| tensor.entries());
        Symmetric3::from_entries(core::array::from_fn(|i| Jet([j[i], first[i], second[i]])))
    }
}

/// The link's parameters in its frame.
fn body<'g>(chain: &Chain<Expr<'g>>, link: &Link<Expr<'g>>, frame: &Turning<'g>) -> Body<Jet<'g>> {
    Body {
        mass: constant(chain, link.body.mass),
        moment: frame.spun(link.body.moment),
        inertia: frame.spun_tensor(link.body.inertia),
    }
}

fn constant<'g>(chain: &Chain<Expr<'g>>, x: Expr<'g>) -> Jet<'g> {
    Jet([x, chain.zero, chain.zero])
}

/// Newton-Euler over jets.
fn forces<'g>(chain: &Chain<Expr<'g>>, links: &[Moving<'g>], course: &Course<'g>) -> Vec<Jet<'g>> {
    let zero = constant(chain, chain.zero);
    let gravity = chain.gravity.0.map(|g| {
        let first = g.derivative(&course.along);
        Jet([g, first, first.derivative(&course.along)])
    });
    let gravity = Vector3(gravity);
    let base = Acceleration::of_base(zero, gravity);
    let mut own = Vec::with_capacity(links.len());
    chain.tree.outward(base, |i, before| {
        let acceleration = links[i].accelerate(before, course.qd[i], course.qdd[i]);
        own.push(links[i].writing.force(&acceleration, &links[i].body));
        acceleration
    });
    let mut forces = vec![zero; links.len()];
    chain
        .tree
        .inward(Force::splat(zero), Force::add, |i, outer| {
            let (link, force) = (&links[i], own[i] + outer);
            let of_motor = constant(chain, link.reflected) * course.qdd[i];
            forces[i] = force.along(link.axis_motion) + of_motor;
            link.hand_on(force)
        });
    forces
}
