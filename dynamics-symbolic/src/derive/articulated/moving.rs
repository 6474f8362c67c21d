//! Articulated bodies of an arm that moves under gravity (Featherstone 1983; 2008, table 7.1).
//!
//! With c_i the part of the acceleration of link i that depends on velocities alone, b_i the wrench that its own
//! velocity needs, and a_0 = -g,
//!
//!   p_i = b_i + sum of outer p',   u_i = tau_i - K_i - F_i - S.p_i,   p' = p_i + I' c_i + k u_i,
//!   a' = a_{i-1} + c_i,   qdd_i = u_i / D_i - k.a',   a_i = a' + S qdd_i.
//!
//! Accelerations are those of frames' origins, as everywhere here; b and c belong to that.
//!
//! Each force acts in the directions of the link that it acts on, and passes a joint with the part
//! that the joint does not give way to. A joint space equation takes the difference of the torques
//! instead: of a payload a thousand million times as heavy as its arm, near the stretched pose, that
//! loses eight digits, and this none. So the links keep their own frames and their own parameters.

use super::inertia::Articulated;
use super::{Eliminated, Outer, acceleration, passed};
use crate::derive::chain::Chain;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::spatial::{Acceleration, Force, Joint, Motion};

/// Accelerations under the joint forces `net`, springs and friction taken off, and the pivots of M = U D U^T, for
/// the joint of every row.
pub(in crate::derive) fn forward_dynamics<'g>(
    chain: &Chain<Expr<'g>>,
    qd: &[Expr<'g>],
    net: &[Expr<'g>],
) -> (Vec<Expr<'g>>, Vec<Expr<'g>>) {
    let terms = velocity_terms(chain, qd);
    let joints = inward(chain, &terms, net);
    let pivots = joints.iter().map(|joint| joint.pivot).collect();
    (outward(chain, &terms, &joints), pivots)
}

/// The parts of a link's acceleration and force that depend on velocities alone.
struct VelocityTerms<'g> {
    /// c
    acceleration: Motion<Expr<'g>>,
    /// b
    force: Force<Expr<'g>>,
}

fn velocity_terms<'g>(chain: &Chain<Expr<'g>>, qd: &[Expr<'g>]) -> Vec<VelocityTerms<'g>> {
    let base = Acceleration::turning(chain.zero, Vector3::splat(chain.zero));
    let mut terms = Vec::with_capacity(qd.len());
    chain.tree.outward(base, |i, before| {
        let Acceleration { w, wd, a } = before.enter(chain.joint(i), qd[i], chain.zero);
        let turning = Acceleration::turning(chain.zero, w);
        terms.push(VelocityTerms {
            acceleration: Motion { w: wd, v: a },
            force: turning.force(&chain.links[i].body),
        });
        turning
    });
    terms
}

/// Articulated inertias and bias forces, from the tip inwards.
fn inward<'g>(
    chain: &Chain<Expr<'g>>,
    velocity_terms: &[VelocityTerms<'g>],
    net: &[Expr<'g>],
) -> Vec<Eliminated<'g>> {
    let mut joints = Vec::with_capacity(net.len());
    chain
        .tree
        .inward(Outer::none(chain.zero), Outer::joined, |i, outer| {
            let link = &chain.links[i];
            let inertia = Articulated::rigid(&link.body, chain.zero).joined(&outer.inertia);
            let bias = velocity_terms[i].force + outer.bias;
            let force = net[i] - bias.along(link.joint.joint_type);
            let (joint, free) = passed(chain, link, &inertia, force);
            joints.push(joint);
            if chain.tree.parent(i).is_none() {
                return outer;
            }
            let passed = bias + free.force(velocity_terms[i].acceleration);
            Outer {
                bias: (passed + joint.k * force).leave(&link.joint),
                inertia: carry(&link.joint, &free),
            }
        });
    joints.reverse();
    joints
}

/// An inertia in the previous frame, about its origin.
fn carry<'g>(joint: &Joint<Expr<'g>>, inertia: &Articulated<Expr<'g>>) -> Articulated<Expr<'g>> {
    let slid = inertia.turned_z(joint.turn).moved_z(joint.slide);
    let turn = |inertia: Articulated<_>, axis, turn| inertia.about(axis, |i| i.turned_z(turn));
    let turned = joint.twist.fold(slid, turn);
    turned.turned_z(joint.before).moved(joint.offset)
}

/// Accelerations of the joints, from the base outwards.
fn outward<'g>(
    chain: &Chain<Expr<'g>>,
    velocity_terms: &[VelocityTerms<'g>],
    joints: &[Eliminated<'g>],
) -> Vec<Expr<'g>> {
    let base = Motion {
        w: Vector3::splat(chain.zero),
        v: -chain.gravity,
    };
    let mut qdd = Vec::with_capacity(joints.len());
    chain.tree.outward(base, |i, before| {
        let joint = chain.joint(i);
        let a = before.enter(joint) + velocity_terms[i].acceleration;
        let x = acceleration(joint.joint_type, &joints[i], &a);
        qdd.push(x);
        a.with_joint(joint.joint_type, x)
    });
    qdd
}
