//! The equations of motion of a link in quasi-velocities.
//!
//! With w and v the angular velocity and the velocity of its frame's origin in body coordinates, the
//! Lagrangian's momenta are p = dT/dw = J w + h x v and l = dT/dv = m v + w x h; the Euler-Lagrange
//! equations in these quasi-velocities (Hamel 1904; Kirchhoff's equations) are
//! n = dp/dt + w x p + v x l, f = dl/dt + w x l. Gravity is an acceleration of the base. With
//! U = [wd]x + [w]x[w]x and a the acceleration of the origin they become
//!
//!   f = m a + U h,   n = J wd + w x (J w) + h x a.

use super::{AxisMotion, Body, Force, Joint};
use crate::linear::{Matrix3, Ring, Symmetric3, Vector3};

/// How a link turns and accelerates: all that its equations of motion read.
#[derive(Clone, Copy, Debug)]
pub struct Acceleration<R> {
    /// Angular velocity.
    pub w: Vector3<R>,
    /// Angular acceleration.
    pub wd: Vector3<R>,
    /// Acceleration of the origin, less that of gravity.
    pub a: Vector3<R>,
}

impl<R: Ring> Acceleration<R> {
    /// A base at rest, or rather one that accelerates against gravity.
    pub fn of_base(zero: R, gravity: Vector3<R>) -> Self {
        Acceleration {
            a: -gravity,
            ..Acceleration::turning(zero, Vector3::splat(zero))
        }
    }

    /// A constant angular velocity about an origin at rest.
    pub fn turning(zero: R, w: Vector3<R>) -> Self {
        let none = Vector3::splat(zero);
        Acceleration {
            w,
            wd: none,
            a: none,
        }
    }

    /// `U = [wd]x + [w]x [w]x`: the acceleration of a point at r is a + U r.
    pub fn u(&self) -> Matrix3<R> {
        let ([x, y, z], [xd, yd, zd]) = (self.w.0, self.wd.0);
        let (xx, yy, zz) = (x * x, y * y, z * z);
        let (xy, yz, xz) = (x * y, y * z, x * z);
        Matrix3([
            [-(yy + zz), xy - zd, xz + yd],
            [xy + zd, -(xx + zz), yz - xd],
            [xz - yd, yz + xd, -(xx + yy)],
        ])
    }

    /// The acceleration of the link that the joint carries and moves.
    pub fn enter(&self, joint: &Joint<R>, qd: R, qdd: R) -> Self {
        let carried = Acceleration {
            w: joint.enter(self.w),
            wd: joint.enter(self.wd),
            a: joint.enter(self.a + self.u().apply(joint.position())),
        };
        carried.with_joint(joint.axis_motion, qd, qdd)
    }

    /// With what the joint does besides, in the axes of the link that it moves.
    pub fn with_joint(self, axis_motion: AxisMotion, qd: R, qdd: R) -> Self {
        let Acceleration { w, wd, a } = self;
        match axis_motion {
            // w' = w + qd z, wd' = wd + qdd z + w x z qd
            AxisMotion::Turns => Acceleration {
                w: Vector3::new(w[0], w[1], w[2] + qd),
                wd: Vector3::new(wd[0] + w[1] * qd, wd[1] - w[0] * qd, wd[2] + qdd),
                a,
            },
            // a' = a + qdd z + 2 w x z qd
            AxisMotion::Slides => {
                let twice = qd + qd;
                Acceleration {
                    w,
                    wd,
                    a: Vector3::new(a[0] + w[1] * twice, a[1] - w[0] * twice, a[2] + qdd),
                }
            }
        }
    }

    /// The force that a body needs to be accelerated so.
    pub fn force(&self, body: &Body<R>) -> Force<R> {
        self.force_by(body, self.moments(&body.inertia), self.squares())
    }

    /// y^2 - z^2, z^2 - x^2 and x^2 - y^2.
    pub(super) fn squares(&self) -> [R; 3] {
        let [xx, yy, zz] = self.w.0.map(|x| x * x);
        [yy - zz, zz - xx, xx - yy]
    }

    /// The part of J wd + w x (J w) that the moments of inertia make up.
    fn moments(&self, j: &Symmetric3<R>) -> Vector3<R> {
        let ([x, y, z], [xd, yd, zd]) = (self.w.0, self.wd.0);
        Vector3::new(
            j.xx * xd + (j.zz - j.yy) * (y * z),
            j.yy * yd + (j.xx - j.zz) * (x * z),
            j.zz * zd + (j.yy - j.xx) * (x * y),
        )
    }

    /// The force, from the part of J wd + w x (J w) that the moments of inertia make up, and from the differences of
    /// squares. The part of the products of inertia is written so that the products of w are those of U.
    pub(super) fn force_by(
        &self,
        body: &Body<R>,
        moments: Vector3<R>,
        [y_z, z_x, x_y]: [R; 3],
    ) -> Force<R> {
        let (j, a) = (&body.inertia, self.a);
        let ([x, y, z], [xd, yd, zd], n) = (self.w.0, self.wd.0, moments);
        let euler = Vector3::new(
            n[0] + j.xy * (yd - x * z) + j.xz * (zd + x * y) + j.yz * y_z,
            n[1] + j.yz * (zd - x * y) + j.xy * (xd + y * z) + j.xz * z_x,
            n[2] + j.xz * (xd - y * z) + j.yz * (yd + x * z) + j.xy * x_y,
        );
        Force {
            n: euler + body.moment.cross(a),
            f: a * body.mass + self.u().apply(body.moment),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const W: Vector3<i64> = Vector3([2, -3, 5]);
    const WD: Vector3<i64> = Vector3([7, 11, -13]);
    const A: Vector3<i64> = Vector3([-17, 19, 23]);

    /// f = m a + wd x h + w x (w x h), n = J wd + w x (J w) + h x a.
    #[test]
    fn newton_and_euler() {
        let (w, wd, a) = (W, WD, A);
        let body = Body {
            mass: 29,
            moment: Vector3([31, -37, 41]),
            inertia: Symmetric3 {
                xx: 43,
                yy: 47,
                zz: 53,
                xy: -59,
                yz: 61,
                xz: -67,
            },
        };
        let (j, h) = (body.inertia, body.moment);
        let force = Acceleration { w, wd, a }.force(&body);
        assert_eq!(force.f, a * body.mass + wd.cross(h) + w.cross(w.cross(h)));
        assert_eq!(force.n, j.apply(wd) + w.cross(j.apply(w)) + h.cross(a));
    }

    #[test]
    fn points_of_a_link_are_accelerated_by_u() {
        let link = Acceleration { w: W, wd: WD, a: A };
        let r = Vector3([3, 1, -4]);
        assert_eq!(link.u().apply(r), WD.cross(r) + W.cross(W.cross(r)));
    }
}
