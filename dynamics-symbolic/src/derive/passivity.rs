//! M qdd_r + C(q, qd) qd_r + G in one pass, C of the Christoffel symbols and never formed.
//!
//! C(q, a) b = sum c_ijk a_k b_j is the symmetric bilinear form of which V(q, qd) is the square. So are
//! the equations of motion link by link, where second derivatives of a link's pose along one velocity
//! become mixed ones along both. With w the angular velocity by qd, w_r that by qd_r, the orientation R
//! of a link has the mixed derivative (Niemeyer and Slotine 1991 carry two velocities through
//! Newton-Euler alike; that theirs is no C of Christoffel symbols is what Echeandia and Wensing 2021
//! put right)
//!
//!   U = [e]x + [w_r]x [w]x = [e]x + w w_r' - (w . w_r) 1,
//!
//! with e that of the angular velocity w_r along qd: joint i adds qdd_r z and (w x z) qd_r to it. The
//! origin accelerates by a, to which a prismatic joint adds qdd_r z + (w x z) qd_r + (w_r x z) qd.
//! A body takes the force m a + U h and the moment h x a + sum m r x (U r).

use super::chain::Chain;
use crate::linear::{Matrix3, Ring, Vector3};
use crate::spatial::{AxisMotion, Body, Force, Joint};

/// How a link moves by two velocities.
pub(super) struct Mixed<R> {
    w: Vector3<R>,
    w_r: Vector3<R>,
    e: Vector3<R>,
    a: Vector3<R>,
}

/// The two velocities of a joint, and the reference acceleration.
#[derive(Clone, Copy)]
pub(super) struct Rates<R> {
    pub(super) qd: R,
    pub(super) qd_r: R,
    pub(super) qdd_r: R,
}

impl<R: Ring> Mixed<R> {
    /// The motion of the link that the joint carries and moves.
    fn enter(&self, joint: &Joint<R>, rates: Rates<R>) -> Self {
        let Rates { qd, qd_r, qdd_r } = rates;
        let [w, w_r, e] = [self.w, self.w_r, self.e].map(|v| joint.enter(v));
        let a = joint.enter(self.a + self.u().apply(joint.position()));
        match joint.axis_motion {
            AxisMotion::Turns => Mixed {
                w: w.plus_z(qd),
                w_r: w_r.plus_z(qd_r),
                e: Vector3::new(e[0] + w[1] * qd_r, e[1] - w[0] * qd_r, e[2] + qdd_r),
                a,
            },
            AxisMotion::Slides => Mixed {
                w,
                w_r,
                e,
                a: Vector3::new(
                    a[0] + (w[1] * qd_r + w_r[1] * qd),
                    a[1] - (w[0] * qd_r + w_r[0] * qd),
                    a[2] + qdd_r,
                ),
            },
        }
    }

    /// U
    fn u(&self) -> Matrix3<R> {
        let ([x, y, z], [u, v, t], [ex, ey, ez]) = (self.w.0, self.w_r.0, self.e.0);
        let (xx, yy, zz) = (x * u, y * v, z * t);
        Matrix3([
            [-(yy + zz), x * v - ez, x * t + ey],
            [y * u + ez, -(xx + zz), y * t - ex],
            [z * u - ey, z * v + ex, -(xx + yy)],
        ])
    }

    /// The force that a body takes.
    pub(super) fn force(&self, body: &Body<R>, half: R) -> Force<R> {
        let u = self.u();
        Force {
            n: moment(body, &u, half) + body.moment.cross(self.a),
            f: self.a * body.mass + u.apply(body.moment),
        }
    }
}

/// sum m r x (U r), with the second moments E = tr(J)/2 1 - J of the body's mass.
fn moment<R: Ring>(body: &Body<R>, u: &Matrix3<R>, half: R) -> Vector3<R> {
    let (j, u) = (&body.inertia, &u.0);
    let second = |other: R, another: R, own: R| half * (other + another - own);
    let (xx, yy, zz) = (
        second(j.yy, j.zz, j.xx),
        second(j.xx, j.zz, j.yy),
        second(j.xx, j.yy, j.zz),
    );
    Vector3::new(
        yy * u[2][1] - zz * u[1][2] - j.xy * u[2][0] + j.xz * u[1][0] + j.yz * (u[1][1] - u[2][2]),
        zz * u[0][2] - xx * u[2][0] - j.yz * u[0][1] + j.xy * u[2][1] + j.xz * (u[2][2] - u[0][0]),
        xx * u[1][0] - yy * u[0][1] - j.xz * u[1][2] + j.yz * u[0][2] + j.xy * (u[0][0] - u[1][1]),
    )
}

/// The motions of all links, of a base that accelerates against gravity.
pub(super) fn motions<R: Ring>(chain: &Chain<R>, rates: &[Rates<R>]) -> Vec<Mixed<R>> {
    let rest = Vector3::splat(chain.zero);
    let base = Mixed {
        w: rest,
        w_r: rest,
        e: rest,
        a: -chain.gravity,
    };
    chain
        .tree
        .outward(base, |i, before| before.enter(chain.joint(i), rates[i]))
}

/// M qdd_r + C(q, qd) qd_r + G.
pub(super) fn torque<R: Ring>(chain: &Chain<R>, rates: &[Rates<R>], half: R) -> Vec<R> {
    let motions = motions(chain, rates);
    let links = chain.links.iter().zip(&motions);
    let forces: Vec<_> = links.map(|(link, m)| m.force(&link.body, half)).collect();
    let qdd_r: Vec<_> = rates.iter().map(|rates| rates.qdd_r).collect();
    super::recursive::inward(chain, &forces, &qdd_r)
}
