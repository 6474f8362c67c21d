//! Kinetic and potential energy.

use super::chain::Chain;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::spatial::{AxisMotion, Motion};

/// T = sum 1/2 w.J w + v.(w x h) + 1/2 m v.v, and 1/2 r^2 J_m qd^2 for each motor.
pub(super) fn kinetic_energy<'g>(chain: &Chain<Expr<'g>>, qd: &[Expr<'g>]) -> Expr<'g> {
    let zero = chain.zero;
    let half = zero.graph.half();
    // 2 T - 2 v.(w x h), and v.(w x h)
    let (mut squares, mut mixed) = (zero, zero);
    chain.tree.outward(Motion::splat(zero), |i, before| {
        let (link, qd) = (&chain.links[i], qd[i]);
        let joint = &link.joint;
        // The linear velocity first: the graph orders the terms of a sum as they were first written.
        let v = joint.enter(before.at(joint.position()).v);
        let entered = before.enter(joint);
        let motion = Motion { v, ..entered }.with_joint(joint.axis_motion, qd);
        let (Motion { w, v }, body) = (motion, &link.body);
        squares = squares
            + w.dot(body.inertia.apply(w))
            + body.mass * v.dot(v)
            + link.reflected * (qd * qd);
        mixed = mixed + body.moment.dot(v.cross(w));
        motion
    });
    half * squares + mixed
}

/// U = -g.h - m g.p, with m the mass and h the first moment of the whole arm about the base's origin,
/// which is at p in the world.
pub(super) fn potential_energy<'g>(chain: &Chain<Expr<'g>>) -> Expr<'g> {
    let (_, (mass, moment)) = scaled_moments(chain, chain.one);
    let about_base = -chain.gravity.dot(chain.base.moment + moment);
    if chain.datum.is_zero() {
        return about_base;
    }
    about_base - chain.datum * (chain.base.mass + mass)
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
    let gravity = Vector3(chain.gravity.0.map(|component| component / scale));
    let (moments, _) = scaled_moments(chain, scale);
    let mut forces = Vec::with_capacity(moments.len());
    chain.tree.outward(gravity, |i, &before| {
        let (joint, (mass, h)) = (chain.joint(i), moments[i]);
        let g = joint.enter(before);
        forces.push(match joint.axis_motion {
            AxisMotion::Turns => g[0] * h[1] - g[1] * h[0],
            AxisMotion::Slides => -(mass * g[2]),
        });
        g
    });
    forces
}

/// A mass and a first moment.
pub(super) type Moment<'g> = (Expr<'g>, Vector3<Expr<'g>>);

/// Mass and first moment of links i to n about the origin of frame i, times `scale`, for every i, and those of all
/// about the origin of frame 0.
fn scaled_moments<'g>(chain: &Chain<Expr<'g>>, scale: Expr<'g>) -> (Vec<Moment<'g>>, Moment<'g>) {
    composite_moments(chain, |i| {
        let body = &chain.links[i].body;
        (body.mass * scale, body.moment * scale)
    })
}

/// Mass and first moment of links i to n about the origin of frame i, for every i, and those of all about the
/// origin of frame 0, from those of each link.
pub(super) fn composite_moments<'g>(
    chain: &Chain<Expr<'g>>,
    own: impl Fn(usize) -> Moment<'g>,
) -> (Vec<Moment<'g>>, Moment<'g>) {
    let none = (chain.zero, Vector3::splat(chain.zero));
    let mut composites = vec![none; chain.links.len()];
    let add = |a: Moment<'g>, b: Moment<'g>| (a.0 + b.0, a.1 + b.1);
    let of_all = chain.tree.inward(none, add, |i, outer| {
        let (mass, moment) = add(own(i), outer);
        composites[i] = (mass, moment);
        let joint = chain.joint(i);
        (mass, joint.leave(moment) + joint.position() * mass)
    });
    (composites, of_all)
}
