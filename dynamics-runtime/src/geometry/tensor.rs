//! The inertia tensor of a row.

use nalgebra::Matrix3;

use crate::Row;

/// The inertia tensor about the centre of mass.
pub fn tensor(row: &Row) -> Matrix3<f64> {
    let [xx, yy, zz, xy, yz, xz] = row.inertia;
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
}
