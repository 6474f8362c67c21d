//! Matrices.

use super::{Ring, Vector3};
use crate::operators::impl_operators;
use core::ops::Mul;

/// A 3 x 3 matrix by rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix3<R>(pub [[R; 3]; 3]);

impl<R: Ring> Matrix3<R> {
    /// `[v]x`: times a vector it is the cross product of v and that.
    pub fn cross(v: Vector3<R>, zero: R) -> Self {
        let [x, y, z] = v.0;
        Matrix3([[zero, -z, y], [z, zero, -x], [-y, x, zero]])
    }

    /// The matrix times a vector.
    pub fn apply(&self, v: Vector3<R>) -> Vector3<R> {
        Vector3(self.0.map(|row| Vector3(row).dot(v)))
    }

    /// The transpose.
    pub fn transpose(&self) -> Self {
        let m = &self.0;
        Matrix3(core::array::from_fn(|i| core::array::from_fn(|j| m[j][i])))
    }

    /// Column j.
    pub fn column(&self, j: usize) -> Vector3<R> {
        Vector3(self.0.map(|row| row[j]))
    }

    /// The matrix product.
    pub fn product(&self, other: &Self) -> Self {
        let columns = other.transpose();
        Matrix3(
            self.0
                .map(|row| columns.0.map(|column| Vector3(row).dot(Vector3(column)))),
        )
    }
}

/// A symmetric 3 x 3 matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetric3<R> {
    /// Entry (1, 1).
    pub xx: R,
    /// Entry (2, 2).
    pub yy: R,
    /// Entry (3, 3).
    pub zz: R,
    /// Entry (1, 2).
    pub xy: R,
    /// Entry (2, 3).
    pub yz: R,
    /// Entry (1, 3).
    pub xz: R,
}

impl<R: Ring> Symmetric3<R> {
    /// The matrix with these entries: xx, yy, zz, xy, yz, xz, the order of a table's cells.
    pub fn from_entries([xx, yy, zz, xy, yz, xz]: [R; 6]) -> Self {
        Symmetric3 {
            xx,
            yy,
            zz,
            xy,
            yz,
            xz,
        }
    }

    /// The entries in the order of [`Symmetric3::from_entries`].
    pub fn entries(&self) -> [R; 6] {
        [self.xx, self.yy, self.zz, self.xy, self.yz, self.xz]
    }

    /// The matrix whose entries are those of this one, mapped by `f`.
    pub fn map<S: Ring>(&self, f: impl Fn(R) -> S) -> Symmetric3<S> {
        Symmetric3::from_entries(self.entries().map(f))
    }

    /// The matrix of the results of an operation on the entries of two.
    fn zip(&self, other: &Self, operation: impl Fn(R, R) -> R) -> Self {
        let (a, b) = (self.entries(), other.entries());
        Symmetric3::from_entries(core::array::from_fn(|i| operation(a[i], b[i])))
    }

    /// The same entry everywhere.
    pub fn splat(x: R) -> Self {
        Symmetric3::from_entries([x; 6])
    }

    /// The matrix times a vector.
    pub fn apply(&self, v: Vector3<R>) -> Vector3<R> {
        let [x, y, z] = v.0;
        Vector3::new(
            self.xx * x + self.xy * y + self.xz * z,
            self.xy * x + self.yy * y + self.yz * z,
            self.xz * x + self.yz * y + self.zz * z,
        )
    }

    /// All nine entries.
    pub fn full(&self) -> Matrix3<R> {
        Matrix3([
            [self.xx, self.xy, self.xz],
            [self.xy, self.yy, self.yz],
            [self.xz, self.yz, self.zz],
        ])
    }

    /// The upper triangle of a matrix that is symmetric.
    pub fn from_upper(m: &Matrix3<R>) -> Self {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = m.0;
        Symmetric3::from_entries([xx, yy, zz, xy, yz, xz])
    }

    /// R J R^T
    pub fn rotated(&self, rotation: &Matrix3<R>) -> Self {
        let turned = rotation.product(&self.full());
        Symmetric3::from_upper(&turned.product(&rotation.transpose()))
    }

    /// `[z]x J - J [z]x`: the derivative, by the angle, of a tensor J that turns about z.
    pub fn slope_about_z(&self, zero: R) -> Self {
        Symmetric3 {
            xx: -(self.xy + self.xy),
            yy: self.xy + self.xy,
            zz: zero,
            xy: self.xx - self.yy,
            yz: self.xz,
            xz: -self.yz,
        }
    }

    /// m (r.r 1 - r r^T): the tensor, about the origin, of a point of mass m at r with the first moment h = m r.
    pub fn of_point(h: Vector3<R>, r: Vector3<R>) -> Self {
        let ([hx, hy, hz], [x, y, z]) = (h.0, r.0);
        Symmetric3 {
            xx: hy * y + hz * z,
            yy: hx * x + hz * z,
            zz: hx * x + hy * y,
            xy: -(hx * y),
            yz: -(hy * z),
            xz: -(hx * z),
        }
    }

    /// The change of the inertia of a body with the first moment h by a shift by r, to first order in r:
    /// 2 (h.r) 1 - h r^T - r h^T.
    pub fn shift(h: Vector3<R>, r: Vector3<R>) -> Self {
        let ([a, b, c], [x, y, z]) = (h.0, r.0);
        let (ax, by, cz) = (a * x, b * y, c * z);
        Symmetric3 {
            xx: by + by + cz + cz,
            yy: ax + ax + cz + cz,
            zz: ax + ax + by + by,
            xy: -(a * y + b * x),
            yz: -(b * z + c * y),
            xz: -(a * z + c * x),
        }
    }
}

impl_operators! {
    impl [R: Ring] for Symmetric3<R>;
    Add add |a, b| a.zip(&b, |a, b| a + b);
    Sub sub |a, b| a.zip(&b, |a, b| a - b);
}

impl<R: Ring> Mul<R> for Symmetric3<R> {
    type Output = Self;

    fn mul(self, k: R) -> Self {
        self.map(|x| x * k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const INERTIA: Symmetric3<i64> = Symmetric3 {
        xx: 2,
        yy: 3,
        zz: 5,
        xy: 7,
        yz: 11,
        xz: 13,
    };
    const V: Vector3<i64> = Vector3([1, -2, 4]);
    const H: Vector3<i64> = Vector3([3, 5, -7]);

    /// x to y, y to z, z to x: a rotation.
    const CYCLE: Matrix3<i64> = Matrix3([[0, 0, 1], [1, 0, 0], [0, 1, 0]]);

    #[test]
    fn a_product_applies_the_right_factor_first() {
        let (a, b) = (INERTIA.full(), Matrix3::cross(H, 0));
        assert_eq!(a.product(&b).apply(V), a.apply(b.apply(V)));
        assert_eq!(b.apply(V), H.cross(V));
        assert_eq!(b.transpose().apply(V), V.cross(H));
        assert_eq!(a.column(2), Vector3([13, 11, 5]));
    }

    #[test]
    fn a_symmetric_matrix_acts_as_its_nine_entries() {
        assert_eq!(INERTIA.apply(V), INERTIA.full().apply(V));
        assert_eq!(Symmetric3::from_upper(&INERTIA.full()), INERTIA);
        assert_eq!(INERTIA + INERTIA - INERTIA * 2, Symmetric3::splat(0));
    }

    #[test]
    fn a_rotated_tensor_acts_in_the_turned_axes() {
        let rotated = INERTIA.rotated(&CYCLE);
        let expected = CYCLE.apply(INERTIA.apply(CYCLE.transpose().apply(V)));
        assert_eq!(rotated.apply(V), expected);
        assert_eq!((rotated.xx, rotated.yy, rotated.zz), (5, 2, 3));
    }

    /// 2 (h.r) 1 - h r^T - r h^T = -([h]x [r]x + [r]x [h]x)
    #[test]
    fn the_shift_of_a_first_moment() {
        let shift = Symmetric3::shift(H, V);
        let both = |x: Vector3<i64>| -(H.cross(V.cross(x)) + V.cross(H.cross(x)));
        for x in [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Vector3) {
            assert_eq!(shift.apply(x), both(x));
        }
    }
}
