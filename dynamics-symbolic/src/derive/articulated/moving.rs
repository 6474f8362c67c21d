//! Articulated bodies of an arm that moves under gravity (Featherstone 1983; 2008, table 7.1).
//!
//! With c_i the acceleration that link i owes to velocities alone, b_i the wrench that its own
//! velocity needs, and a_0 = -g,
//!
//!   p_i = b_i + sum of outer p',   u_i = tau_i - F_i - S.p_i,   p' = p_i + I' c_i + k u_i,
//!   a' = a_{i-1} + c_i,   qdd_i = u_i / D_i - k.a',   a_i = a' + S qdd_i.
//!
//! Accelerations are those of frames' origins, as everywhere here; b and c belong to that.
//!
//! Each force acts in the directions of the link that it acts on, and passes a joint with the part
//! that the joint does not give way to. A joint space equation takes the difference of the torques
//! instead: of a payload a thousand million times as heavy as its arm, near the stretched pose, that
//! loses eight digits, and this none. So the links keep their own frames and their own parameters.

use super::inertia::Articulated;
use super::{Eliminated, Spatial, acceleration, carry_wrench, passed};
use crate::derive::chain::{Chain, Link};
use crate::derive::recursive::{self, Motion};
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::robot::JointType;

/// Accelerations under the joint forces `net`, friction taken off, and the pivots of M = U D U^T, for
/// the joint of every row.
pub(in crate::derive) fn forward_dynamics<'g>(
    chain: &Chain<'g>,
    qd: &[Expr<'g>],
    net: &[Expr<'g>],
) -> (Vec<Expr<'g>>, Vec<Expr<'g>>) {
    let owed = owed(chain, qd);
    let joints = inward(chain, &owed, net);
    let pivots = joints.iter().map(|joint| joint.pivot).collect();
    (outward(chain, &owed, &joints), pivots)
}

/// What a link owes to velocities alone.
struct Owed<'g> {
    /// c
    acceleration: Spatial<'g>,
    /// b
    wrench: Spatial<'g>,
}

fn owed<'g>(chain: &Chain<'g>, qd: &[Expr<'g>]) -> Vec<Owed<'g>> {
    let none = Vector3::splat(chain.zero);
    let mut w = none;
    let of_link = |(link, &qd): (&Link<'g>, &Expr<'g>)| {
        let before = Motion {
            w,
            ..Motion::of_base(chain.zero, none)
        };
        let c = recursive::outward(chain, link, before, qd, chain.zero);
        w = c.w;
        let turning = Motion {
            w,
            ..Motion::of_base(chain.zero, none)
        };
        let (force, moment) = recursive::wrench(&link.body, &turning);
        Owed {
            acceleration: Spatial {
                angular: c.wd,
                linear: c.a,
            },
            wrench: Spatial {
                angular: moment,
                linear: force,
            },
        }
    };
    chain.links.iter().zip(qd).map(of_link).collect()
}

/// Articulated inertias and bias forces, from the tip inwards.
fn inward<'g>(chain: &Chain<'g>, owed: &[Owed<'g>], net: &[Expr<'g>]) -> Vec<Eliminated<'g>> {
    let mut joints = Vec::with_capacity(net.len());
    let mut outer: Option<Articulated<Expr<'g>>> = None;
    let mut outer_bias = Spatial::zero(chain);
    for (i, link) in chain.links.iter().enumerate().rev() {
        let own = Articulated::rigid(&link.body, chain.zero);
        let inertia = outer.map_or(own, |outer| own.joined(&outer));
        let bias = owed[i].wrench.and(outer_bias);
        let force = net[i] - bias.along(link.joint_type);
        let (joint, free) = passed(chain, link, &inertia, force);
        joints.push(joint);
        if i > 0 {
            let passed = bias.and(free.wrench(owed[i].acceleration));
            outer_bias = carry_wrench(chain, link, passed.plus(joint.k, force));
            outer = Some(carry(link, &free));
        }
    }
    joints.reverse();
    joints
}

/// An inertia in the previous frame, about its origin.
fn carry<'g>(link: &Link<'g>, inertia: &Articulated<Expr<'g>>) -> Articulated<Expr<'g>> {
    let slid = inertia.turned_z(link.turn).moved_z(link.slide);
    let turned = slid.turned_x(link.twist).turned_z(link.before);
    turned.moved(link.offset)
}

/// Accelerations of the joints, from the base outwards.
fn outward<'g>(chain: &Chain<'g>, owed: &[Owed<'g>], joints: &[Eliminated<'g>]) -> Vec<Expr<'g>> {
    let mut a = Spatial {
        angular: Vector3::splat(chain.zero),
        linear: -chain.gravity,
    };
    let mut qdd = Vec::with_capacity(joints.len());
    for ((link, owed), joint) in chain.links.iter().zip(owed).zip(joints) {
        a = link
            .carry_acceleration(chain.zero, a)
            .and(owed.acceleration);
        let x = acceleration(link, joint, &a);
        match link.joint_type {
            JointType::Revolute => a.angular.0[2] = a.angular[2] + x,
            JointType::Prismatic => a.linear.0[2] = a.linear[2] + x,
        }
        qdd.push(x);
    }
    qdd
}
