//! Rotations about one coordinate axis.

use crate::linear::{Ring, Symmetric3, Vector3};

/// A rotation about a coordinate axis, by its sine and cosine.
#[derive(Clone, Copy, Debug)]
pub struct Turn<R> {
    /// Sine of the angle.
    pub s: R,
    /// Cosine of the angle.
    pub c: R,
}

impl<R: Ring> Turn<R> {
    /// No turn at all.
    pub fn none(zero: R, one: R) -> Self {
        Turn { s: zero, c: one }
    }

    /// Rotates a pair (u, v) in the plane of the turn: coordinates in the turned
    /// frame to coordinates in the frame before the turn.
    pub fn leave(self, u: R, v: R) -> (R, R) {
        (self.c * u - self.s * v, self.s * u + self.c * v)
    }

    /// The inverse of [`Turn::leave`]: into the turned frame.
    pub fn enter(self, u: R, v: R) -> (R, R) {
        (self.c * u + self.s * v, self.c * v - self.s * u)
    }

    /// The same in other numbers.
    pub fn map<S>(self, number: impl Fn(R) -> S) -> Turn<S> {
        Turn {
            s: number(self.s),
            c: number(self.c),
        }
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

/// Sine and cosine.
impl<R> From<(R, R)> for Turn<R> {
    fn from((s, c): (R, R)) -> Self {
        Turn { s, c }
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

/// Rotation about y, out of the turned frame.
pub fn leave_y<R: Ring>(turn: Turn<R>, v: Vector3<R>) -> Vector3<R> {
    let (z, x) = turn.leave(v[2], v[0]);
    Vector3::new(x, v[1], z)
}

/// Rotation about y, into the turned frame.
pub fn enter_y<R: Ring>(turn: Turn<R>, v: Vector3<R>) -> Vector3<R> {
    let (z, x) = turn.enter(v[2], v[0]);
    Vector3::new(x, v[1], z)
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

/// A tensor's components, out of a frame that is turned about x.
pub fn tensor_leave_x<R: Ring>(turn: Turn<R>, j: Symmetric3<R>) -> Symmetric3<R> {
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

/// A tensor's components, out of a frame that is turned about y.
pub fn tensor_leave_y<R: Ring>(turn: Turn<R>, j: Symmetric3<R>) -> Symmetric3<R> {
    let (zz, xx, xz) = turn.leave_block(j.zz, j.xx, j.xz);
    let (yz, xy) = turn.leave(j.yz, j.xy);
    Symmetric3 {
        xx,
        yy: j.yy,
        zz,
        xy,
        yz,
        xz,
    }
}

/// A tensor's components, out of a frame that is turned about z.
pub fn tensor_leave_z<R: Ring>(turn: Turn<R>, j: Symmetric3<R>) -> Symmetric3<R> {
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
