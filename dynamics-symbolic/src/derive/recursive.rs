//! The equations of motion in quasi-velocities, link by link.
//!
//! For each link, with w and v its angular velocity and the velocity of its
//! frame's origin in body coordinates, the Lagrangian's momenta are
//! p = dT/dw = J w + h x v and l = dT/dv = m v + w x h; the Euler-Lagrange
//! equations in these quasi-velocities (Hamel 1904; Kirchhoff's equations)
//! are n = dp/dt + w x p + v x l, f = dl/dt + w x l. Gravity is an
//! acceleration of the base. With U = [wd]x + [w]x[w]x and a the acceleration
//! of the origin they become
//!
//!   f = m a + U h,   n = J wd + w x (J w) + h x a.

use super::chain::{Chain, Link};
use super::inertia::Body;
use crate::expr::Expr;
use crate::linear::{Matrix3, Vector3};
use crate::robot::JointType;

type Vector<'g> = Vector3<Expr<'g>>;

/// The motion of one link.
#[derive(Clone, Copy)]
pub(super) struct Motion<'g> {
    /// Angular velocity.
    pub(super) w: Vector<'g>,
    /// Angular acceleration.
    pub(super) wd: Vector<'g>,
    /// Acceleration of the origin, less that of gravity.
    pub(super) a: Vector<'g>,
}

impl<'g> Motion<'g> {
    /// A base at rest, or rather one that accelerates against gravity.
    pub(super) fn of_base(zero: Expr<'g>, gravity: Vector<'g>) -> Self {
        let rest = Vector3::splat(zero);
        Motion {
            w: rest,
            wd: rest,
            a: -gravity,
        }
    }

    /// U = [wd]x + [w]x [w]x: the acceleration of a point at r is a + U r.
    pub(super) fn u(&self) -> Matrix3<Expr<'g>> {
        let ([x, y, z], [xd, yd, zd]) = (self.w.0, self.wd.0);
        let (xx, yy, zz) = (x * x, y * y, z * z);
        let (xy, yz, xz) = (x * y, y * z, x * z);
        Matrix3([
            [-(yy + zz), xy - zd, xz + yd],
            [xy + zd, -(xx + zz), yz - xd],
            [xz - yd, yz + xd, -(xx + yy)],
        ])
    }
}

/// Joint forces of a motion: M qdd + V (+ G where `gravity` is the chain's), without friction.
pub(super) fn inverse_dynamics<'g>(
    chain: &Chain<'g>,
    qd: &[Expr<'g>],
    qdd: &[Expr<'g>],
    gravity: Vector<'g>,
) -> Vec<Expr<'g>> {
    let motions = motions(chain, qd, qdd, gravity);
    let links = chain.links.iter().zip(&motions);
    let wrenches = links.map(|(link, motion)| wrench(&link.body, motion));
    inward(chain, wrenches.collect(), qdd)
}

/// The motions of the links, from the base outwards.
pub(super) fn motions<'g>(
    chain: &Chain<'g>,
    qd: &[Expr<'g>],
    qdd: &[Expr<'g>],
    gravity: Vector<'g>,
) -> Vec<Motion<'g>> {
    let mut motion = Motion::of_base(chain.zero, gravity);
    let joints = chain.links.iter().zip(qd.iter().zip(qdd));
    let motions = joints.map(|(link, (&qd, &qdd))| {
        motion = outward(chain, link, motion, qd, qdd);
        motion
    });
    motions.collect()
}

/// The motion of a link from that of the previous one.
pub(super) fn outward<'g>(
    chain: &Chain<'g>,
    link: &Link<'g>,
    previous: Motion<'g>,
    qd: Expr<'g>,
    qdd: Expr<'g>,
) -> Motion<'g> {
    let zero = chain.zero;
    let w = link.enter(previous.w);
    let wd = link.enter(previous.wd);
    let a = link.enter(previous.a + previous.u().apply(link.position(zero)));
    match link.joint_type {
        // w' = w + qd z, wd' = wd + qdd z + w x z qd
        JointType::Revolute => Motion {
            w: Vector3::new(w[0], w[1], w[2] + qd),
            wd: Vector3::new(wd[0] + w[1] * qd, wd[1] - w[0] * qd, wd[2] + qdd),
            a,
        },
        // a' = a + qdd z + 2 w x z qd
        JointType::Prismatic => {
            let twice = qd + qd;
            Motion {
                w,
                wd,
                a: Vector3::new(a[0] + w[1] * twice, a[1] - w[0] * twice, a[2] + qdd),
            }
        }
    }
}

/// Force and moment about the origin that the link's motion needs.
pub(super) fn wrench<'g>(body: &Body<Expr<'g>>, motion: &Motion<'g>) -> (Vector<'g>, Vector<'g>) {
    let a = motion.a;
    let f = a * body.mass + motion.u().apply(body.moment);
    let n = euler(body, motion) + body.moment.cross(a);
    (f, n)
}

/// J wd + w x (J w), written so that the products of w are those of U.
fn euler<'g>(body: &Body<Expr<'g>>, motion: &Motion<'g>) -> Vector<'g> {
    let j = &body.inertia;
    let ([x, y, z], [xd, yd, zd]) = (motion.w.0, motion.wd.0);
    let (xx, yy, zz) = (x * x, y * y, z * z);
    Vector3::new(
        j.xx * xd
            + (j.zz - j.yy) * (y * z)
            + j.xy * (yd - x * z)
            + j.xz * (zd + x * y)
            + j.yz * (yy - zz),
        j.yy * yd
            + (j.xx - j.zz) * (x * z)
            + j.yz * (zd - x * y)
            + j.xy * (xd + y * z)
            + j.xz * (zz - xx),
        j.zz * zd
            + (j.yy - j.xx) * (x * y)
            + j.xz * (xd - y * z)
            + j.yz * (yd + x * z)
            + j.xy * (xx - yy),
    )
}

/// Joint forces from the links' wrenches, from the tip inwards.
fn inward<'g>(
    chain: &Chain<'g>,
    wrenches: Vec<(Vector<'g>, Vector<'g>)>,
    qdd: &[Expr<'g>],
) -> Vec<Expr<'g>> {
    let mut forces = vec![chain.zero; chain.links.len()];
    let mut outer = (Vector3::splat(chain.zero), Vector3::splat(chain.zero));
    for (i, link) in chain.links.iter().enumerate().rev() {
        let (f, n) = (wrenches[i].0 + outer.0, wrenches[i].1 + outer.1);
        let along = match link.joint_type {
            JointType::Revolute => n[2],
            JointType::Prismatic => f[2],
        };
        forces[i] = along + link.reflected * qdd[i];
        let f = link.leave(f);
        outer = (f, link.leave(n) + link.position(chain.zero).cross(f));
    }
    forces
}
