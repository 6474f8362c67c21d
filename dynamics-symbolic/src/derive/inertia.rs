//! Mass, first moment and inertia of a body about the origin of a frame.

use crate::linear::{Ring, Symmetric3, Vector3};

/// A rigid body: T = 1/2 w.J w + v.(w x h) + 1/2 m v.v, linear in its ten parameters.
#[derive(Clone, Copy, Debug)]
pub struct Body<R> {
    /// Mass m.
    pub mass: R,
    /// First moment h = m c about the frame's origin.
    pub moment: Vector3<R>,
    /// Inertia tensor J about the frame's origin.
    pub inertia: Symmetric3<R>,
}

/// A rotation about a coordinate axis, by its sine and cosine.
#[derive(Clone, Copy, Debug)]
pub struct Turn<R> {
    /// Sine of the angle.
    pub s: R,
    /// Cosine of the angle.
    pub c: R,
}

impl<R: Ring> Turn<R> {
    /// Rotates a pair (u, v) in the plane of the turn: coordinates in the turned
    /// frame to coordinates in the frame before the turn.
    pub fn leave(self, u: R, v: R) -> (R, R) {
        (self.c * u - self.s * v, self.s * u + self.c * v)
    }

    /// The inverse of [`Turn::leave`]: into the turned frame.
    pub fn enter(self, u: R, v: R) -> (R, R) {
        (self.c * u + self.s * v, self.c * v - self.s * u)
    }

    /// Both turns, one after the other.
    pub fn plus(self, other: Self) -> Self {
        let (c, s) = self.leave(other.c, other.s);
        Turn { s, c }
    }

    /// The 2 x 2 symmetric block (uu, vv, uv), out of the turned frame.
    ///
    /// With k = s (uu - vv) + 2 c uv: uu' = uu - s k, vv' = vv + s k, uv' = c k - uv.
    pub fn leave_block(self, uu: R, vv: R, uv: R) -> (R, R, R) {
        let k = self.s * (uu - vv) + self.c * (uv + uv);
        let sk = self.s * k;
        (uu - sk, vv + sk, self.c * k - uv)
    }
}

/// Rotation about x, out of the turned frame.
pub fn leave_x<R: Ring>(turn: Turn<R>, v: Vector3<R>) -> Vector3<R> {
    let (y, z) = turn.leave(v[1], v[2]);
    Vector3::new(v[0], y, z)
}

/// Rotation about x, into the turned frame.
pub fn enter_x<R: Ring>(turn: Turn<R>, v: Vector3<R>) -> Vector3<R> {
    let (y, z) = turn.enter(v[1], v[2]);
    Vector3::new(v[0], y, z)
}

/// Rotation about z, out of the turned frame.
pub fn leave_z<R: Ring>(turn: Turn<R>, v: Vector3<R>) -> Vector3<R> {
    let (x, y) = turn.leave(v[0], v[1]);
    Vector3::new(x, y, v[2])
}

/// Rotation about z, into the turned frame.
pub fn enter_z<R: Ring>(turn: Turn<R>, v: Vector3<R>) -> Vector3<R> {
    let (x, y) = turn.enter(v[0], v[1]);
    Vector3::new(x, y, v[2])
}

fn tensor_leave_x<R: Ring>(turn: Turn<R>, j: Symmetric3<R>) -> Symmetric3<R> {
    let (yy, zz, yz) = turn.leave_block(j.yy, j.zz, j.yz);
    let (xy, xz) = turn.leave(j.xy, j.xz);
    Symmetric3 {
        xx: j.xx,
        yy,
        zz,
        xy,
        yz,
        xz,
    }
}

fn tensor_leave_z<R: Ring>(turn: Turn<R>, j: Symmetric3<R>) -> Symmetric3<R> {
    let (xx, yy, xy) = turn.leave_block(j.xx, j.yy, j.xy);
    let (xz, yz) = turn.leave(j.xz, j.yz);
    Symmetric3 {
        xx,
        yy,
        zz: j.zz,
        xy,
        yz,
        xz,
    }
}

impl<R: Ring> Body<R> {
    /// The same parameter ten times (for zero).
    pub fn splat(x: R) -> Self {
        Body {
            mass: x,
            moment: Vector3::splat(x),
            inertia: Symmetric3::splat(x),
        }
    }

    /// A body by its mass, centre of mass and inertia about the centre of mass:
    /// J = I + m (c.c 1 - c c^T), the parallel-axis theorem.
    pub fn new(mass: R, com: Vector3<R>, inertia: Symmetric3<R>) -> Self {
        let [x, y, z] = com.0;
        let moment = com * mass;
        let [hx, hy, hz] = moment.0;
        let steiner = Symmetric3 {
            xx: hy * y + hz * z,
            yy: hx * x + hz * z,
            zz: hx * x + hy * y,
            xy: -(hx * y),
            yz: -(hy * z),
            xz: -(hx * z),
        };
        Body {
            mass,
            moment,
            inertia: inertia + steiner,
        }
    }

    /// Both bodies as one.
    pub fn joined(self, other: Self) -> Self {
        Body {
            mass: self.mass + other.mass,
            moment: self.moment + other.moment,
            inertia: self.inertia + other.inertia,
        }
    }

    /// What is left of it without the other.
    pub fn less(self, other: Self) -> Self {
        Body {
            mass: self.mass - other.mass,
            moment: self.moment - other.moment,
            inertia: self.inertia - other.inertia,
        }
    }

    /// In the frame before a turn about x.
    pub fn left_x(self, turn: Turn<R>) -> Self {
        Body {
            mass: self.mass,
            moment: leave_x(turn, self.moment),
            inertia: tensor_leave_x(turn, self.inertia),
        }
    }

    /// In the frame before a turn about z.
    pub fn left_z(self, turn: Turn<R>) -> Self {
        Body {
            mass: self.mass,
            moment: leave_z(turn, self.moment),
            inertia: tensor_leave_z(turn, self.inertia),
        }
    }

    /// About a point from which the old origin is at `r`:
    /// J' = J + 2 (h.r) 1 - h r^T - r h^T + m (r.r 1 - r r^T), h' = h + m r.
    pub fn moved(self, r: Vector3<R>) -> Self {
        let mr = r * self.mass;
        let point = {
            let [x, y, z] = r.0;
            let [hx, hy, hz] = mr.0;
            Symmetric3 {
                xx: hy * y + hz * z,
                yy: hx * x + hz * z,
                zz: hx * x + hy * y,
                xy: -(hx * y),
                yz: -(hy * z),
                xz: -(hx * z),
            }
        };
        Body {
            mass: self.mass,
            moment: self.moment + mr,
            inertia: self.inertia + Symmetric3::shift(self.moment, r) + point,
        }
    }

    /// About a point from which the old origin is at (0, 0, d):
    /// J_xx' = J_xx + d (h_z + h_z') and J_yy' alike, with h_z' = h_z + m d.
    pub fn moved_z(self, d: R) -> Self {
        let [x, y, z] = self.moment.0;
        let z_moved = z + self.mass * d;
        let p = d * (z + z_moved);
        let mut moved = self;
        moved.moment.0[2] = z_moved;
        moved.inertia.xx = self.inertia.xx + p;
        moved.inertia.yy = self.inertia.yy + p;
        moved.inertia.yz = self.inertia.yz - d * y;
        moved.inertia.xz = self.inertia.xz - d * x;
        moved
    }

    /// The part that is invariant under rotation about z, and the rest without
    /// mass and h_z, and without J_yy or J_xx (Gautier and Khalil 1990).
    pub fn split_revolute(self, zero: R, keep: Keep) -> (Self, Self) {
        let moving = match keep {
            Keep::Xx => self.inertia.yy,
            Keep::Yy => self.inertia.xx,
        };
        let mut invariant = Body::splat(zero);
        invariant.mass = self.mass;
        invariant.moment.0[2] = self.moment[2];
        invariant.inertia.xx = moving;
        invariant.inertia.yy = moving;
        let mut rest = self;
        rest.mass = zero;
        rest.moment.0[2] = zero;
        rest.inertia.xx = self.inertia.xx - moving;
        rest.inertia.yy = self.inertia.yy - moving;
        (invariant, rest)
    }
}

/// Which of J_xx and J_yy remains on a link behind a revolute joint; only their difference matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// J_xx - J_yy, as J_xx.
    Xx,
    /// J_yy - J_xx, as J_yy.
    Yy,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn along_z_a_body_moves_as_along_any_vector() {
        let body = Body {
            mass: 3,
            moment: Vector3([5, -7, 11]),
            inertia: Symmetric3 {
                xx: 2,
                yy: -3,
                zz: 13,
                xy: 17,
                yz: 19,
                xz: 23,
            },
        };
        let (along_z, by_vector) = (body.moved_z(4), body.moved(Vector3([0, 0, 4])));
        assert_eq!(along_z.mass, by_vector.mass);
        assert_eq!(along_z.moment, by_vector.moment);
        assert_eq!(along_z.inertia, by_vector.inertia);
    }
}
