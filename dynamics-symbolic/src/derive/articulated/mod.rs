//! Forward dynamics by articulated bodies (Featherstone 1983; Featherstone 2008, 7.3).
//!
//! Link i with the joints beyond it free opposes acceleration by its articulated inertia I_i
//! and needs the wrench p_i besides. With S the direction of joint i, U = I S, D = S.U + the
//! reflected inertia, k = U / D and u = tau_i - S.p, what the link is to the one before is
//!
//!   I' = I - U k^T,   p' = p + k u,   qdd_i = u / D - k.a',
//!
//! where a' is the acceleration that the link would have with its joint at rest. The D are the
//! pivots of M = U D U^T from the tip inwards: the elimination is the same, in other variables.
//!
//! Forces that do not depend on accelerations are left to the recursive equations of motion:
//! what is accelerated here is an arm at rest without gravity, by tau - V - G - F. [`moving`] is the
//! algorithm as it was published, on which all forces act.
//!
//! The definitions of what depends on the pivots are held: see [`super::solve`].

mod inertia;
mod moving;

use super::chain::{Chain, Link};
use crate::expr::Expr;
use crate::linear::{Matrix3, Symmetric3, Vector3};
use crate::robot::JointType;
use inertia::Articulated;
pub(super) use moving::forward_dynamics;

type Vector<'g> = Vector3<Expr<'g>>;

/// A moment and a force, or an angular and a linear acceleration.
#[derive(Clone, Copy)]
struct Spatial<'g> {
    angular: Vector<'g>,
    linear: Vector<'g>,
}

impl<'g> Spatial<'g> {
    fn zero(chain: &Chain<'g>) -> Self {
        let zero = Vector3::splat(chain.zero);
        Spatial {
            angular: zero,
            linear: zero,
        }
    }

    /// Both together.
    fn and(self, other: Self) -> Self {
        Spatial {
            angular: self.angular + other.angular,
            linear: self.linear + other.linear,
        }
    }

    fn plus(self, k: Self, factor: Expr<'g>) -> Self {
        Spatial {
            angular: self.angular + k.angular * factor,
            linear: self.linear + k.linear * factor,
        }
    }

    /// The component in the direction of a joint.
    fn along(&self, joint_type: JointType) -> Expr<'g> {
        match joint_type {
            JointType::Revolute => self.angular[2],
            JointType::Prismatic => self.linear[2],
        }
    }
}

/// A joint, taken out of the equations.
#[derive(Clone, Copy)]
struct Eliminated<'g> {
    /// D
    pivot: Expr<'g>,
    /// 1 / D
    reciprocal: Expr<'g>,
    /// k = U / D
    k: Spatial<'g>,
    /// u
    force: Expr<'g>,
}

/// Solves M qdd = `net`: qdd, and the pivots of M = U D U^T, for the joint of every row. One that is
/// locked has the acceleration 0.
pub(super) fn solve<'g>(chain: &Chain<'g>, net: &[Expr<'g>]) -> (Vec<Expr<'g>>, Vec<Expr<'g>>) {
    let joints = inward(chain, net);
    let pivots = joints.iter().map(|joint| joint.pivot).collect();
    let qdd = chain.zero.graph.holding(|| outward(chain, &joints));
    (qdd, pivots)
}

/// What a link is to the one before it once its joint is out of the equations; a joint that is
/// locked gives way to nothing.
fn passed<'g>(
    chain: &Chain<'g>,
    link: &Link<'g>,
    inertia: &Articulated<Expr<'g>>,
    force: Expr<'g>,
) -> (Eliminated<'g>, Articulated<Expr<'g>>) {
    if link.locked {
        let none = Eliminated {
            pivot: chain.one,
            reciprocal: chain.one,
            k: Spatial::zero(chain),
            force: chain.zero,
        };
        return (none, *inertia);
    }
    chain.zero.graph.holding(|| {
        let joint = eliminate(chain, link, inertia, force);
        (joint, free(link, inertia, &joint.k))
    })
}

/// Articulated inertias and bias forces, from the tip inwards.
fn inward<'g>(chain: &Chain<'g>, net: &[Expr<'g>]) -> Vec<Eliminated<'g>> {
    let zero = chain.zero;
    let mut joints = Vec::with_capacity(net.len());
    let mut outer: Option<Articulated<Expr<'g>>> = None;
    let mut bias = Spatial::zero(chain);
    for (i, link) in chain.links.iter().enumerate().rev() {
        let own = Articulated::rigid(&link.body, zero);
        let inertia = outer.map_or(own, |outer| own.joined(&outer));
        let force = net[i] - bias.along(link.joint_type);
        let (joint, free) = passed(chain, link, &inertia, force);
        joints.push(joint);
        if i > 0 {
            outer = Some(carry(link, &free));
            bias = carry_wrench(chain, link, bias.plus(joint.k, force));
        }
    }
    joints.reverse();
    joints
}

fn eliminate<'g>(
    chain: &Chain<'g>,
    link: &Link<'g>,
    inertia: &Articulated<Expr<'g>>,
    force: Expr<'g>,
) -> Eliminated<'g> {
    let u = direction(link, inertia);
    let pivot = u.along(link.joint_type) + link.reflected;
    let reciprocal = chain.one / pivot;
    Eliminated {
        pivot,
        reciprocal,
        k: Spatial {
            angular: u.angular * reciprocal,
            linear: u.linear * reciprocal,
        },
        force,
    }
}

/// U = I S
fn direction<'g>(link: &Link<'g>, inertia: &Articulated<Expr<'g>>) -> Spatial<'g> {
    let (j, h, m) = (&inertia.angular, &inertia.coupling, &inertia.linear);
    match link.joint_type {
        JointType::Revolute => Spatial {
            angular: Vector3::new(j.xz, j.yz, j.zz),
            linear: Vector3(h.0[2]),
        },
        JointType::Prismatic => Spatial {
            angular: h.column(2),
            linear: Vector3::new(m.xz, m.yz, m.zz),
        },
    }
}

/// I' = I - U k^T: the joint moves freely, but for its reflected inertia r. I' S = r k.
fn free<'g>(
    link: &Link<'g>,
    inertia: &Articulated<Expr<'g>>,
    k: &Spatial<'g>,
) -> Articulated<Expr<'g>> {
    let u = direction(link, inertia);
    let outer = |a: Vector<'g>, b: Vector<'g>| Matrix3(a.0.map(|a| b.0.map(|b| a * b)));
    let upper = |a, b| Symmetric3::from_upper(&outer(a, b));
    let coupling = outer(u.angular, k.linear);
    let rows = [0, 1, 2].map(|i| (Vector3(inertia.coupling.0[i]) - Vector3(coupling.0[i])).0);
    let mut free = Articulated {
        angular: inertia.angular - upper(u.angular, k.angular),
        coupling: Matrix3(rows),
        linear: inertia.linear - upper(u.linear, k.linear),
    };
    let (rest, tensor) = match link.joint_type {
        JointType::Revolute => {
            free.coupling.0[2] = (k.linear * link.reflected).0;
            (k.angular * link.reflected, &mut free.angular)
        }
        JointType::Prismatic => {
            let column = k.angular * link.reflected;
            for i in 0..3 {
                free.coupling.0[i][2] = column[i];
            }
            (k.linear * link.reflected, &mut free.linear)
        }
    };
    (tensor.xz, tensor.yz, tensor.zz) = (rest[0], rest[1], rest[2]);
    free
}

/// An inertia in the previous frame, about its origin.
fn carry<'g>(link: &Link<'g>, inertia: &Articulated<Expr<'g>>) -> Articulated<Expr<'g>> {
    let slid = inertia.left_z(link.turn).moved_z(link.slide);
    let turned = slid.left_x(link.twist).left_z(link.before);
    turned.moved(link.offset)
}

/// A wrench in the previous frame, about its origin.
fn carry_wrench<'g>(chain: &Chain<'g>, link: &Link<'g>, wrench: Spatial<'g>) -> Spatial<'g> {
    let f = link.leave(wrench.linear);
    Spatial {
        angular: link.leave(wrench.angular) + link.position(chain.zero).cross(f),
        linear: f,
    }
}

impl<'g> Link<'g> {
    /// The acceleration of the previous frame, of this one's origin and in its axes.
    fn carry_acceleration(&self, zero: Expr<'g>, a: Spatial<'g>) -> Spatial<'g> {
        let r = self.position(zero);
        Spatial {
            angular: self.enter(a.angular),
            linear: self.enter(a.linear + a.angular.cross(r)),
        }
    }
}

impl<'g> Articulated<Expr<'g>> {
    /// n = J wd + H a, f = H^T wd + M a
    fn wrench(&self, a: Spatial<'g>) -> Spatial<'g> {
        Spatial {
            angular: self.angular.apply(a.angular) + self.coupling.apply(a.linear),
            linear: self.coupling.transpose().apply(a.angular) + self.linear.apply(a.linear),
        }
    }
}

/// Accelerations of the joints, from the base outwards.
fn outward<'g>(chain: &Chain<'g>, joints: &[Eliminated<'g>]) -> Vec<Expr<'g>> {
    let mut a = Spatial::zero(chain);
    let mut qdd = Vec::with_capacity(joints.len());
    for (link, joint) in chain.links.iter().zip(joints) {
        a = link.carry_acceleration(chain.zero, a);
        let x = acceleration(link, joint, &a);
        match link.joint_type {
            JointType::Revolute => a.angular.0[2] = a.angular[2] + x,
            JointType::Prismatic => a.linear.0[2] = a.linear[2] + x,
        }
        qdd.push(x);
    }
    qdd
}

/// qdd = u / D - k.a'. Along the joint's axis k is 1 where no inertia is reflected: that term
/// comes last, for what is left of it is the link's acceleration about or along the axis.
fn acceleration<'g>(link: &Link<'g>, joint: &Eliminated<'g>, a: &Spatial<'g>) -> Expr<'g> {
    let k = &joint.k;
    let (last, others) = match link.joint_type {
        JointType::Revolute => ((k.angular, a.angular), (k.linear, a.linear)),
        JointType::Prismatic => ((k.linear, a.linear), (k.angular, a.angular)),
    };
    let (k, a) = last;
    let across = others.0.dot(others.1) + (k[0] * a[0] + k[1] * a[1]);
    joint.force * joint.reciprocal - across - k[2] * a[2]
}
