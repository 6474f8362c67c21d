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

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// x
    X,
    /// y
    Y,
    /// z
    Z,
}

impl Axis {
    /// The indices of the axis and of the two that follow it in the order x, y, z, x, y.
    pub fn indices(self) -> [usize; 3] {
        [0, 1, 2].map(|k| (self as usize + k) % 3)
    }
}

/// Rotation about a coordinate axis, out of the turned frame.
pub fn leave_about<R: Ring>(axis: Axis, turn: Turn<R>, mut v: Vector3<R>) -> Vector3<R> {
    let [_, i, j] = axis.indices();
    (v.0[i], v.0[j]) = turn.leave(v[i], v[j]);
    v
}

/// Rotation about a coordinate axis, into the turned frame.
pub fn enter_about<R: Ring>(axis: Axis, turn: Turn<R>, mut v: Vector3<R>) -> Vector3<R> {
    let [_, i, j] = axis.indices();
    (v.0[i], v.0[j]) = turn.enter(v[i], v[j]);
    v
}

/// A tensor's components, out of a frame that is turned about a coordinate axis.
pub fn tensor_leave_about<R: Ring>(
    axis: Axis,
    turn: Turn<R>,
    tensor: Symmetric3<R>,
) -> Symmetric3<R> {
    let [k, i, j] = axis.indices();
    // Entry (i, j) of the products stands at the index of the axis that is neither.
    let mut squares = [tensor.xx, tensor.yy, tensor.zz];
    let mut products = [tensor.yz, tensor.xz, tensor.xy];
    (squares[i], squares[j], products[k]) = turn.leave_block(squares[i], squares[j], products[k]);
    (products[j], products[i]) = turn.leave(products[j], products[i]);
    let ([xx, yy, zz], [yz, xz, xy]) = (squares, products);
    Symmetric3::from_entries([xx, yy, zz, xy, yz, xz])
}
