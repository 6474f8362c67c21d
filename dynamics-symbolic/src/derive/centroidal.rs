//! The centroidal momentum matrix, and the rate of A v at constant velocities.
//!
//! A v is the linear momentum of all bodies, then their angular momentum about the common centre of mass c (Orin, Goswami and
//! Lee 2013). With (n_j, f_j) the momentum that unit velocity of joint j gives the body of links j to the tips, about a
//! point o_j of its axis, column j is
//!
//!   (f_j, n_j + (o_j - c) x f_j),
//!
//! a column of M before it is projected (Wensing and Orin 2016), in the axes of the world. The rate of A v is the force on all
//! bodies and its moment about c: the velocity of c has no part in it, for the linear momentum is parallel to it. So
//!
//!   dA/dt v = (f, n - c x f),
//!
//! with the force f and the moment n about the origin of frame 0 that the links need for their motion without gravity, if
//! the velocities v are constant. Motors are no bodies here, and nothing is neglected, as for the centre of mass.

use super::base;
use super::center_of_mass::{in_base, total_mass};
use super::chain::Chain;
use super::kinematics::{self, Pose};
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::spatial::{Axis, Body, Force, leave_about};
use core::ops::Add;

/// A by rows.
pub(super) fn matrix<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Vec<Expr<'g>> {
    let (bodies, of_base) = bodies(symbols, chain);
    let (composites, of_joints) = composites(chain, &bodies);
    let center = (of_base + of_joints) * (chain.one / total_mass(symbols));
    let base = axes_of_base(symbols, chain);
    let center_in_world = base.leave(center);
    let mut columns = Vec::with_capacity(chain.links.len());
    chain.tree.outward((base, center), |i, (before, center)| {
        let joint = chain.joint(i);
        let mut frame = before.turned(Axis::Z, joint.before);
        frame = frame.turned_by(&joint.twist);
        let [_, _, z] = frame.axes;
        frame.origin = before.origin + before.leave(joint.offset) + z * joint.slide;
        let Force { n, f } = composites[i].momentum(chain.axis(i));
        let linear = frame.leave(f);
        let (center, angular) = if chain.links[i].is_of_base {
            // About the centre of mass in axes of frame 0, where the columns of all turns are a symmetric tensor.
            let center = joint.enter(*center - joint.position());
            let before_turn = leave_about(Axis::Z, joint.turn, center);
            (center, frame.leave(n - before_turn.cross(f)))
        } else {
            let lever = frame.origin - center_in_world;
            (*center, frame.leave(n) + lever.cross(linear))
        };
        columns.push((linear, angular));
        (frame.turned(Axis::Z, joint.turn), center)
    });
    kinematics::by_rows(&columns)
}

/// dA/dt v, of these velocities and of the accelerations if they are constant: zero, except for the joints of a base
/// that moves.
pub(super) fn bias<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    [qd, still]: [&[Expr<'g>]; 2],
) -> Vec<Expr<'g>> {
    let motions = chain.accelerations(Vector3::splat(chain.zero), qd, still);
    let (bodies, _) = bodies(symbols, chain);
    let none = Force::splat(chain.zero);
    let Force { n, f } = chain.tree.inward(none, Force::add, |i, outer| {
        let force = motions[i].force(&bodies[i]) + outer;
        force.leave(chain.joint(i))
    });
    let moment = n - in_base(symbols, chain).cross(f);
    let base = axes_of_base(symbols, chain);
    [f, moment].map(|x| base.leave(x).0).concat()
}

/// The axes of frame 0 in the world. No place matters to a momentum about the centre of mass: the origin is that of frame 0.
fn axes_of_base<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Pose<'g> {
    Pose {
        origin: Vector3::splat(chain.zero),
        ..kinematics::base(symbols)
    }
}

/// The bodies of the links, and the first moment of what no joint moves: those of the chain, or of the complete robot where
/// parameters are neglected.
fn bodies<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
) -> (Vec<Body<Expr<'g>>>, Vector3<Expr<'g>>) {
    let arm = symbols.arm();
    if arm.neglected.is_none() {
        let bodies = chain.links.iter().map(|link| link.body);
        return (bodies.collect(), chain.base.moment);
    }
    let complete = base::bodies(symbols, arm).into_iter().enumerate();
    let placed = complete.map(|(i, (body, _))| match arm.is_of_base(i) {
        true => Body::splat(chain.zero),
        false => chain.links[i].place(body, chain.zero),
    });
    (placed.collect(), Vector3::splat(chain.zero))
}

/// Links j to the tips as one body for every j, about the origin of frame j, in the axes before the joint's own turn: a body
/// takes that turn on its way inwards anyway. Then the first moment of all about the origin of frame 0.
fn composites<'g>(
    chain: &Chain<Expr<'g>>,
    bodies: &[Body<Expr<'g>>],
) -> (Vec<Body<Expr<'g>>>, Vector3<Expr<'g>>) {
    let none = Body::splat(chain.zero);
    let mut composites = vec![none; bodies.len()];
    let all = chain.tree.inward(none, Body::joined, |j, outer| {
        let composite = outer.joined(bodies[j]);
        let joint = chain.joint(j);
        composites[j] = composite.left(Axis::Z, joint.turn);
        match chain.tree.parent(j) {
            Some(_) => joint.leave_body(composite),
            None => Body {
                moment: joint.leave(composite.moment) + joint.position() * composite.mass,
                ..none
            },
        }
    });
    (composites, all.moment)
}
