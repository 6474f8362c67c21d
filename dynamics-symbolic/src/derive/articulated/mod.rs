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
//! [`solve`] leaves the forces that do not depend on accelerations to the recursive equations of motion: it accelerates
//! an arm at rest without gravity, by tau - V - G - K - F. [`forward_dynamics`] is the algorithm as it was published
//! (Featherstone 2008, table 7.1), on which all forces act. With c_i the part of the acceleration of link i that depends
//! on velocities alone, b_i the wrench that its own velocity needs, and a_0 = -g, it has
//!
//!   p_i = b_i + sum of outer p',   u_i = tau_i - K_i - F_i - S.p_i,   p' = p_i + I' c_i + k u_i,
//!   a' = a_{i-1} + c_i,   qdd_i = u_i / D_i - k.a',   a_i = a' + S qdd_i.
//!
//! Accelerations are those of frames' origins, as everywhere here; b and c belong to that. Each force acts in the
//! directions of the link that it acts on, and passes a joint with the part that the joint does not give way to. A joint
//! space equation takes the difference of the torques instead: of a payload a thousand million times as heavy as its
//! arm, near the stretched pose, that loses eight digits, and this none. So the links keep their own frames and their
//! own parameters.
//!
//! The definitions of what depends on the pivots are held: see [`super::solve`].
//!
//! `forward_dynamics_aba` is the algorithm as it was published, all forces included, on the links' own frames and
//! parameters: no base parameters, no frames that stay behind, no simplification, and turns of inertias in which no
//! component is a difference of larger ones. Each of these would cost digits where M is nearly singular:
//! `tests/scene/articulated.rs` measures how many.

mod inertia;

use super::chain::{Chain, Link};
use crate::expr::Expr;
use crate::linear::{Matrix3, Symmetric3, Vector3};
use crate::spatial::{Acceleration, AxisMotion, Body, Force, Joint, Motion, Turn};
use inertia::Articulated;

type Vector<'g> = Vector3<Expr<'g>>;

/// A joint, taken out of the equations.
#[derive(Clone, Copy)]
struct Eliminated<'g> {
    /// D
    pivot: Expr<'g>,
    /// 1 / D
    reciprocal: Expr<'g>,
    /// k = U / D
    k: Force<Expr<'g>>,
    /// u
    force: Expr<'g>,
}

/// The parts of a link's acceleration and force that depend on velocities alone.
#[derive(Clone, Copy)]
struct VelocityTerms<'g> {
    /// c
    acceleration: Motion<Expr<'g>>,
    /// b
    force: Force<Expr<'g>>,
}

/// The inertia in the frame before a turn about z: [`Articulated::left_z`] or [`Articulated::turned_z`].
type LeaveZ<'g> = fn(&Articulated<Expr<'g>>, Turn<Expr<'g>>) -> Articulated<Expr<'g>>;

/// Solves M qdd = `net`: qdd, and the pivots of M = U D U^T, for the joint of every row. One that is
/// locked has the acceleration 0.
pub(super) fn solve<'g>(
    chain: &Chain<Expr<'g>>,
    net: &[Expr<'g>],
) -> (Vec<Expr<'g>>, Vec<Expr<'g>>) {
    let none = VelocityTerms {
        acceleration: Motion::splat(chain.zero),
        force: Force::splat(chain.zero),
    };
    let terms = vec![none; net.len()];
    let joints = inward(chain, &terms, net, Articulated::left_z);
    let pivots = joints.iter().map(|joint| joint.pivot).collect();
    let at_rest = Vector3::splat(chain.zero);
    let qdd = || outward(chain, at_rest, &terms, &joints);
    (chain.zero.graph.holding(qdd), pivots)
}

/// Accelerations under the joint forces `net`, springs and friction taken off, and the pivots of M = U D U^T, for
/// the joint of every row.
pub(super) fn forward_dynamics<'g>(
    chain: &Chain<Expr<'g>>,
    qd: &[Expr<'g>],
    net: &[Expr<'g>],
) -> (Vec<Expr<'g>>, Vec<Expr<'g>>) {
    let terms = velocity_terms(chain, qd);
    let joints = inward(chain, &terms, net, Articulated::turned_z);
    let pivots = joints.iter().map(|joint| joint.pivot).collect();
    let qdd = outward(chain, -chain.gravity, &terms, &joints);
    (qdd, pivots)
}

fn velocity_terms<'g>(chain: &Chain<Expr<'g>>, qd: &[Expr<'g>]) -> Vec<VelocityTerms<'g>> {
    let base = Acceleration::turning(chain.zero, Vector3::splat(chain.zero));
    let mut terms = Vec::with_capacity(qd.len());
    chain.tree.outward(base, |i, before| {
        let Acceleration { w, wd, a } = before.enter(chain.joint(i), qd[i], chain.zero);
        let turning = Acceleration::turning(chain.zero, w);
        terms.push(VelocityTerms {
            acceleration: Motion { w: wd, v: a },
            force: chain.links[i].writing.force(&turning, &chain.links[i].body),
        });
        turning
    });
    terms
}

/// The joint of a link, taken out of the equations, and the inertia that the link then has for the one before. A joint
/// that is locked gives way to nothing.
fn passed<'g>(
    chain: &Chain<Expr<'g>>,
    link: &Link<Expr<'g>>,
    inertia: &Articulated<Expr<'g>>,
    force: Expr<'g>,
) -> (Eliminated<'g>, Articulated<Expr<'g>>) {
    if link.stands {
        let none = Eliminated {
            pivot: chain.one,
            reciprocal: chain.one,
            k: Force::splat(chain.zero),
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
fn inward<'g>(
    chain: &Chain<Expr<'g>>,
    velocity_terms: &[VelocityTerms<'g>],
    net: &[Expr<'g>],
    leave_z: LeaveZ<'g>,
) -> Vec<Eliminated<'g>> {
    let mut joints = Vec::with_capacity(net.len());
    let none = Outer::none(chain.zero);
    chain.tree.inward(none, Outer::joined, |i, outer| {
        let link = &chain.links[i];
        let inertia = Articulated::rigid(&link.body, chain.zero).joined(&outer.inertia);
        let bias = velocity_terms[i].force + outer.bias;
        let force = net[i] - bias.along(link.joint.axis_motion);
        let (joint, free) = passed(chain, link, &inertia, force);
        joints.push(joint);
        if chain.tree.parent(i).is_none() {
            return outer;
        }
        let passed = bias + free.force(velocity_terms[i].acceleration);
        Outer {
            bias: (passed + joint.k * force).leave(&link.joint),
            inertia: carry(&link.joint, &free, leave_z),
        }
    });
    joints.reverse();
    joints
}

/// The inertia of the links outside a link, as that link meets it.
#[derive(Clone, Copy)]
struct Outer<'g> {
    inertia: Articulated<Expr<'g>>,
    /// The wrench that they need besides.
    bias: Force<Expr<'g>>,
}

impl<'g> Outer<'g> {
    fn none(zero: Expr<'g>) -> Self {
        Outer {
            inertia: Articulated::rigid(&Body::splat(zero), zero),
            bias: Force::splat(zero),
        }
    }

    fn joined(self, other: Self) -> Self {
        Outer {
            inertia: self.inertia.joined(&other.inertia),
            bias: self.bias + other.bias,
        }
    }
}

fn eliminate<'g>(
    chain: &Chain<Expr<'g>>,
    link: &Link<Expr<'g>>,
    inertia: &Articulated<Expr<'g>>,
    force: Expr<'g>,
) -> Eliminated<'g> {
    let u = direction(link.joint.axis_motion, inertia);
    let pivot = u.along(link.joint.axis_motion) + link.reflected;
    let reciprocal = chain.one / pivot;
    Eliminated {
        pivot,
        reciprocal,
        k: u * reciprocal,
        force,
    }
}

/// U = I S
fn direction<'g>(axis_motion: AxisMotion, inertia: &Articulated<Expr<'g>>) -> Force<Expr<'g>> {
    let (j, h, m) = (&inertia.angular, &inertia.coupling, &inertia.linear);
    match axis_motion {
        AxisMotion::Turns => Force {
            n: Vector3::new(j.xz, j.yz, j.zz),
            f: Vector3(h.0[2]),
        },
        AxisMotion::Slides => Force {
            n: h.column(2),
            f: Vector3::new(m.xz, m.yz, m.zz),
        },
    }
}

/// I' = I - U k^T: the joint moves freely, except for its reflected inertia r. I' S = r k.
fn free<'g>(
    link: &Link<Expr<'g>>,
    inertia: &Articulated<Expr<'g>>,
    k: &Force<Expr<'g>>,
) -> Articulated<Expr<'g>> {
    let u = direction(link.joint.axis_motion, inertia);
    let outer = |a: Vector<'g>, b: Vector<'g>| Matrix3(a.0.map(|a| b.0.map(|b| a * b)));
    let upper = |a, b| Symmetric3::from_upper(&outer(a, b));
    let coupling = outer(u.n, k.f);
    let rows = [0, 1, 2].map(|i| (Vector3(inertia.coupling.0[i]) - Vector3(coupling.0[i])).0);
    let mut free = Articulated {
        angular: inertia.angular - upper(u.n, k.n),
        coupling: Matrix3(rows),
        linear: inertia.linear - upper(u.f, k.f),
    };
    let (rest, tensor) = match link.joint.axis_motion {
        AxisMotion::Turns => {
            free.coupling.0[2] = (k.f * link.reflected).0;
            (k.n * link.reflected, &mut free.angular)
        }
        AxisMotion::Slides => {
            let column = k.n * link.reflected;
            for i in 0..3 {
                free.coupling.0[i][2] = column[i];
            }
            (k.f * link.reflected, &mut free.linear)
        }
    };
    (tensor.xz, tensor.yz, tensor.zz) = (rest[0], rest[1], rest[2]);
    free
}

/// An inertia in the previous frame, about its origin.
fn carry<'g>(
    joint: &Joint<Expr<'g>>,
    inertia: &Articulated<Expr<'g>>,
    leave_z: LeaveZ<'g>,
) -> Articulated<Expr<'g>> {
    let slid = leave_z(inertia, joint.turn).moved_z(joint.slide);
    let left = |inertia: Articulated<_>, axis, turn| inertia.about(axis, |i| leave_z(i, turn));
    let twisted = joint.twist.fold(slid, left);
    leave_z(&twisted, joint.before).moved(joint.offset)
}

/// Accelerations of the joints, from the base outwards, whose origin accelerates.
fn outward<'g>(
    chain: &Chain<Expr<'g>>,
    of_base: Vector<'g>,
    velocity_terms: &[VelocityTerms<'g>],
    joints: &[Eliminated<'g>],
) -> Vec<Expr<'g>> {
    let base = Motion {
        w: Vector3::splat(chain.zero),
        v: of_base,
    };
    let mut qdd = Vec::with_capacity(joints.len());
    chain.tree.outward(base, |i, before| {
        let joint = chain.joint(i);
        let a = before.enter(joint) + velocity_terms[i].acceleration;
        let x = acceleration(joint.axis_motion, &joints[i], &a);
        qdd.push(x);
        a.with_joint(joint.axis_motion, x)
    });
    qdd
}

/// qdd = u / D - k.a'. Along the joint's axis k is 1 where no inertia is reflected: that term
/// comes last, for what is left of it is the link's acceleration about or along the axis.
fn acceleration<'g>(
    axis_motion: AxisMotion,
    joint: &Eliminated<'g>,
    a: &Motion<Expr<'g>>,
) -> Expr<'g> {
    let k = &joint.k;
    let (last, others) = match axis_motion {
        AxisMotion::Turns => ((k.n, a.w), (k.f, a.v)),
        AxisMotion::Slides => ((k.f, a.v), (k.n, a.w)),
    };
    let (k, a) = last;
    let across = others.0.dot(others.1) + (k[0] * a[0] + k[1] * a[1]);
    joint.force * joint.reciprocal - across - k[2] * a[2]
}
