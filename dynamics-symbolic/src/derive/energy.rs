//! Kinetic and potential energy.

use super::chain::Chain;
use crate::exact::Rational;
use crate::expr::{Expr, Graph};
use crate::linear::Vector3;
use crate::robot::JointType;
use crate::spatial::{Joint, Motion};

/// T = sum 1/2 w.J w + v.(w x h) + 1/2 m v.v, and 1/2 r^2 J_m qd^2 for each motor.
pub(super) fn kinetic_energy<'g>(
    graph: &'g Graph,
    chain: &Chain<Expr<'g>>,
    qd: &[Expr<'g>],
) -> Expr<'g> {
    let half = graph.rational(&(Rational::ONE / Rational::from(2)));
    let zero = chain.zero;
    let mut motion = Motion::splat(zero);
    // 2 T - 2 v.(w x h), and v.(w x h)
    let (mut squares, mut mixed) = (zero, zero);
    for (link, &qd) in chain.links.iter().zip(qd) {
        let joint = &link.joint;
        // The linear velocity first: the graph orders the terms of a sum as they were first written.
        let v = joint.enter(motion.at(joint.position()).v);
        let entered = motion.enter(joint);
        motion = Motion { v, ..entered }.with_joint(joint.joint_type, qd);
        let (Motion { w, v }, body) = (motion, &link.body);
        squares = squares
            + w.dot(body.inertia.apply(w))
            + body.mass * v.dot(v)
            + link.reflected * (qd * qd);
        mixed = mixed + body.moment.dot(v.cross(w));
    }
    half * squares + mixed
}

/// U = -g.h - m g.p, with m the mass and h the first moment of the whole arm about the base's origin,
/// which is at p in the world.
pub(super) fn potential_energy<'g>(chain: &Chain<Expr<'g>>) -> Expr<'g> {
    let moments = scaled_moments(chain, chain.one);
    let total = moment_about_base(chain, chain.base.moment, &moments);
    let about_base = -chain.gravity.dot(total);
    if chain.datum.is_zero() {
        return about_base;
    }
    let first = moments.first();
    let mass = first.map_or(chain.base.mass, |(mass, _)| chain.base.mass + *mass);
    about_base - chain.datum * mass
}

/// G = dU/dq from first moments: G_i = z.(g x h_i) for a revolute joint, -m_i g_z
/// for a prismatic one, with the mass and the first moment of links i to n
/// about the origin of frame i.
///
/// Bodies are scaled by one component of g beforehand, so that the direction
/// of gravity is what enters the products: a component of 1 costs nothing. The
/// component must be a number: a parameter may be zero.
pub(super) fn gravity_vector<'g>(chain: &Chain<Expr<'g>>) -> Vec<Expr<'g>> {
    let scale = chain.strength;
    let mut g = Vector3(chain.gravity.0.map(|component| component / scale));
    let moments = scaled_moments(chain, scale);
    let force = |(link, (mass, h)): (&super::chain::Link<Expr<'g>>, &Moment<'g>)| {
        g = link.joint.enter(g);
        match link.joint.joint_type {
            JointType::Revolute => g[0] * h[1] - g[1] * h[0],
            JointType::Prismatic => -(*mass * g[2]),
        }
    };
    chain.links.iter().zip(&moments).map(force).collect()
}

/// A mass and a first moment.
pub(super) type Moment<'g> = (Expr<'g>, Vector3<Expr<'g>>);

/// The first moment of the whole arm about the origin of frame 0: of the base, and of the links as
/// [`composite_moments`] has them.
pub(super) fn moment_about_base<'g>(
    chain: &Chain<Expr<'g>>,
    of_base: Vector3<Expr<'g>>,
    of_links: &[Moment<'g>],
) -> Vector3<Expr<'g>> {
    match chain.joints().zip(of_links).next() {
        Some((joint, &moment)) => of_base + in_previous_frame(joint, moment),
        None => of_base,
    }
}

/// A first moment, with its mass, about the origin of the previous frame.
fn in_previous_frame<'g>(joint: &Joint<Expr<'g>>, (mass, moment): Moment<'g>) -> Vector3<Expr<'g>> {
    joint.leave(moment) + joint.position() * mass
}

/// Mass and first moment of links i to n about the origin of frame i, times `scale`.
fn scaled_moments<'g>(chain: &Chain<Expr<'g>>, scale: Expr<'g>) -> Vec<Moment<'g>> {
    composite_moments(chain, |i| {
        let body = &chain.links[i].body;
        (body.mass * scale, body.moment * scale)
    })
}

/// Mass and first moment of links i to n about the origin of frame i, from those of each link.
pub(super) fn composite_moments<'g>(
    chain: &Chain<Expr<'g>>,
    own: impl Fn(usize) -> Moment<'g>,
) -> Vec<Moment<'g>> {
    let zero = chain.zero;
    let mut composites = Vec::with_capacity(chain.links.len());
    let mut outer = (zero, Vector3::splat(zero));
    for (i, link) in chain.links.iter().enumerate().rev() {
        let own = own(i);
        let mass = own.0 + outer.0;
        let moment = own.1 + outer.1;
        composites.push((mass, moment));
        outer = (mass, in_previous_frame(&link.joint, (mass, moment)));
    }
    composites.reverse();
    composites
}
