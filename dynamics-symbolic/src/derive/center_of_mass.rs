//! The centre of mass of all links, and its Jacobian.
//!
//! Both come from masses and first moments, joined from the tip inwards as for gravity. With m and h
//! those of links i to n about the origin of frame i, and M the mass of all, the centre is h / M of the
//! whole arm, and moves by z x h / M where revolute joint i does, by m z / M where prismatic joint i
//! does. Links whose joints stand still count, except for those that no moving joint carries: they are parts of
//! the base. Nothing is neglected: these are no terms of the equations of motion.

use super::base::{LinkGeometry, bodies, geometry};
use super::chain::Chain;
use super::energy::{Moment, composite_moments};
use super::kinematics::base;
use super::place;
use super::symbols::Symbols;
use crate::expr::{Expr, Graph, Level};
use crate::linear::{Symmetric3, Vector3};
use crate::mechanism::Mechanism;
use crate::robot::{Interpretation, Robot};
use crate::spatial::{Axis, AxisMotion, Body};

/// Whether a robot has no mass that moves, whatever its fields are: then it has no centre of mass.
pub fn is_massless(robot: &Robot) -> bool {
    let (graph, arm) = (Graph::new(), Mechanism::from(robot));
    total_mass(&mut Symbols::new(&graph, &arm)).is_zero()
}

/// The mass of all that moves.
pub(super) fn total_mass<'g>(symbols: &mut Symbols<'g>) -> Expr<'g> {
    let (zero, arm) = (symbols.graph().zero(), symbols.arm());
    let links = arm.joints.iter().map(|joint| &joint.body.mass).enumerate();
    let fixed_bodies = arm.fixed_bodies.iter();
    let masses = links.chain(fixed_bodies.map(|fixed| (fixed.link, &fixed.body.mass)));
    let moving = masses.filter(|(link, _)| !arm.is_of_base(*link));
    moving.fold(zero, |sum, (_, mass)| sum + symbols.value(mass))
}

/// The centre of mass.
pub(super) fn center<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Vec<Expr<'g>> {
    let center = in_base(symbols, chain);
    let base = place::base(symbols, symbols.arm());
    let center = base.map_or(center, |base| base.leave_point(center));
    center.0.to_vec()
}

/// The centre of mass in frame 0.
pub(super) fn in_base<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Vector3<Expr<'g>> {
    let moments = Moments::new(symbols, chain);
    let total = moments.of_base + moments.of_joints;
    Vector3(moments.divided(total.0, chain.one))
}

/// Its Jacobian by rows.
pub(super) fn jacobian<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Vec<Expr<'g>> {
    let moments = Moments::new(symbols, chain);
    let base = base(symbols);
    let mut columns = Vec::with_capacity(chain.links.len());
    chain.tree.outward(base, |i, before| {
        let (joint, (mass, h)) = (chain.joint(i), moments.of_links[i]);
        let before = before.turned(Axis::Z, joint.before);
        let axes = before.turned_by(&joint.twist);
        // In the axes before the joint's own turn, which the moment takes on its way inwards anyway.
        let (x, y) = joint.turn.leave(h[0], h[1]);
        columns.push(match joint.axis_motion {
            AxisMotion::Turns => axes.axes[1] * x - axes.axes[0] * y,
            AxisMotion::Slides => axes.axes[2] * mass,
        });
        axes.turned(Axis::Z, joint.turn)
    });
    let rows = (0..3).flat_map(|k| columns.iter().map(move |column| column[k]));
    let rows: Vec<_> = rows.collect();
    moments.divided(rows, chain.one)
}

/// Masses and first moments, over the mass of all links where that is a number.
struct Moments<'g> {
    /// The moments of links i to n about the origin of frame i, as far as joint i feels them.
    of_links: Vec<Moment<'g>>,
    /// The first moment of what no joint moves, about the origin of frame 0.
    of_base: Vector3<Expr<'g>>,
    /// The first moment of all that joints move.
    of_joints: Vector3<Expr<'g>>,
    /// The mass of all links, where it is still to be divided by.
    divisor: Option<Expr<'g>>,
}

impl<'g> Moments<'g> {
    fn new(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Self {
        let total = total_mass(symbols);
        let is_number = total.level() == Level::Constant && !total.is_zero();
        let scale = if is_number {
            chain.one / total
        } else {
            chain.one
        };
        let (bodies, base) = grouped(symbols, scale);
        let links = chain.links.iter().zip(bodies);
        let placed: Vec<_> = links
            .map(|(link, body)| link.place(body, chain.zero))
            .collect();
        let own = |i: usize| (placed[i].mass, placed[i].moment);
        let (of_links, (_, of_joints)) = composite_moments(chain, own);
        Moments {
            of_links,
            of_base: base.moment,
            of_joints,
            divisor: (!is_number).then_some(total),
        }
    }

    /// Values over the mass of all, where that is still to be done.
    fn divided<V: AsMut<[Expr<'g>]>>(&self, mut values: V, one: Expr<'g>) -> V {
        if let Some(total) = self.divisor {
            let reciprocal = one / total;
            for value in values.as_mut() {
                *value = *value * reciprocal;
            }
        }
        values
    }
}

/// Masses and first moments of all links times a factor, and of the base: what a joint does not move
/// is a part of the link before it, so that it is added to constants.
fn grouped<'g>(
    symbols: &mut Symbols<'g>,
    factor: Expr<'g>,
) -> (Vec<Body<Expr<'g>>>, Body<Expr<'g>>) {
    let (zero, arm) = (symbols.graph().zero(), symbols.arm());
    let geometry = geometry(symbols, arm);
    let own = bodies(symbols, arm);
    let none = Body::splat(zero);
    let mut kept = vec![none; own.len()];
    let of_base = geometry.tree.inward(none, Body::joined, |i, outer| {
        // Parts of the base have no share, but what comes from beyond passes their frames.
        let point = if arm.is_of_base(i) {
            none
        } else {
            Body {
                inertia: Symmetric3::splat(zero),
                ..own[i].0.times(factor)
            }
        };
        let whole = point.joined(outer);
        let (rest, moving) = if arm.joints[i].is_of_base() {
            (whole, none)
        } else {
            split(&geometry.links[i], whole, zero)
        };
        kept[i] = rest;
        Body {
            inertia: Symmetric3::splat(zero),
            ..geometry.leave(i, moving)
        }
    });
    (kept, of_base)
}

/// The parts of a mass and a first moment that a joint moves, and those that it does not.
fn split<'g>(
    link: &LinkGeometry<Expr<'g>>,
    body: Body<Expr<'g>>,
    zero: Expr<'g>,
) -> (Body<Expr<'g>>, Body<Expr<'g>>) {
    let [x, y, z] = body.moment.0;
    let none = Body::splat(zero);
    let of = |mass, x, y, z| Body {
        mass,
        moment: Vector3::new(x, y, z),
        ..none
    };
    match link.axis_motion {
        _ if link.stands => (none, body),
        AxisMotion::Turns => (of(zero, x, y, zero), of(body.mass, zero, zero, z)),
        AxisMotion::Slides => (of(body.mass, zero, zero, zero), of(zero, x, y, z)),
    }
}
