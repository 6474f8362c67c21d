//! Poses: what is taken as one, and with which rotation.

use nalgebra::{Matrix3, Matrix4};

use super::Real;
use super::roots::roundings;

/// A rotation counts as one whose columns are unit vectors at right angles to this: poses are written with three decimals
/// and more.
const NEARLY: f64 = 1e-3;

/// The pose that closed forms solve: a matrix that is one but for its rotation is taken with the nearest rotation, which `place`
/// has room for. None, if the last row is not 0, 0, 0, 1, if max |R'R - 1| > 1e-3, if R mirrors, or if a number is not
/// finite. Where the rotation is not read, only the position has to be finite.
#[inline]
pub fn nearest_pose<'p, T: Real>(
    matrix: &'p Matrix4<T>,
    place: &'p mut Option<Matrix4<T>>,
    reads_rotation: bool,
) -> Option<&'p Matrix4<T>> {
    let [x, y, z, [p, q, r, _]] = &matrix.data.0;
    // No sum: it overflows where its terms do not.
    if !(p.is_finite() && q.is_finite() && r.is_finite()) {
        return None;
    }
    if !reads_rotation {
        return Some(matrix);
    }
    let columns = [x, y, z].map(|column| [column[0], column[1], column[2]]);
    if is_homogeneous(matrix) && is_exact(&columns) {
        return Some(matrix);
    }
    *place = rotated(matrix, columns);
    place.as_ref()
}

/// The numbers that vanish of a rotation: two columns have length one and are at right angles, and their vector product is the third.
#[inline]
fn column_misses<T: Real>([x, y, z]: &[[T; 3]; 3]) -> [T; 6] {
    let one = T::from_f64(1.0);
    let [d, e, f] = cross(x, y);
    [
        dot(x, x) - one,
        dot(y, y) - one,
        dot(x, y),
        d - z[0],
        e - z[1],
        f - z[2],
    ]
}

/// Whether columns are those of a rotation, but for rounding.
#[inline]
fn is_exact<T: Real>(columns: &[[T; 3]; 3]) -> bool {
    let misses = column_misses(columns);
    let squares = misses.iter().map(|miss| *miss * *miss);
    let least = roundings(T::from_f64(4.0));
    squares.fold(T::from_f64(0.0), |sum, square| sum + square) <= least * least
}

/// The pose with the nearest rotation, if it is one to 1e-3.
#[cold]
#[inline(never)]
fn rotated<T: Real>(matrix: &Matrix4<T>, columns: [[T; 3]; 3]) -> Option<Matrix4<T>> {
    let is_nearly = are_small(misses(&columns).as_flattened(), T::from_f64(NEARLY));
    if !(is_nearly && is_homogeneous(matrix) && keeps_sense(&columns)) {
        return None;
    }
    let mut pose = *matrix;
    let columns = nearest_rotation(columns);
    for (place, column) in pose.data.0.iter_mut().zip(columns) {
        place[..3].copy_from_slice(&column);
    }
    Some(pose)
}

/// The orthogonal part of a polar decomposition, by R <- R (3 - R'R) / 2. A miss of 1e-3 becomes 1e-6, 1e-12 and 1e-24
/// (Higham, Functions of Matrices, 2008, 8.3).
fn nearest_rotation<T: Real>(mut columns: [[T; 3]; 3]) -> [[T; 3]; 3] {
    for _ in 0..3 {
        let misses = misses(&columns);
        let by = |j: usize, i: usize| {
            let sum = (0..3).fold(T::from_f64(0.0), |sum, k| {
                sum + columns[k][i] * misses[k][j]
            });
            columns[j][i] - T::from_f64(0.5) * sum
        };
        columns = core::array::from_fn(|j| core::array::from_fn(|i| by(j, i)));
    }
    columns
}

/// R'R - 1
#[inline]
fn misses<T: Real>(columns: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    let [x, y, z] = columns;
    let one = T::from_f64(1.0);
    let [xy, yz, zx] = [dot(x, y), dot(y, z), dot(z, x)];
    [
        [dot(x, x) - one, xy, zx],
        [xy, dot(y, y) - one, yz],
        [zx, yz, dot(z, z) - one],
    ]
}

#[inline]
pub(super) fn dot<T: Real>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(super) fn cross<T: Real>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    let of = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [of(1, 2), of(2, 0), of(0, 1)]
}

/// Whether columns do not mirror.
#[inline]
fn keeps_sense<T: Real>([x, y, z]: &[[T; 3]; 3]) -> bool {
    dot(&cross(x, y), z).is_positive()
}

/// Whether the last row of a matrix is 0, 0, 0, 1, which a transposed pose has as its last column.
#[inline]
pub fn is_homogeneous<T: Real>(matrix: &Matrix4<T>) -> bool {
    let [x, y, z, position] = &matrix.data.0;
    let misses = [x[3], y[3], z[3], position[3] - T::from_f64(1.0)];
    are_small(&misses, T::ROTATION)
}

/// Whether a matrix is a rotation.
#[inline]
pub fn is_rotation<T: Real>(matrix: &Matrix3<T>) -> bool {
    are_small(&column_misses(&matrix.data.0), T::ROTATION)
}

#[inline]
fn are_small<T: Real>(misses: &[T], bound: T) -> bool {
    misses.iter().all(|x| *x <= bound && *x >= -bound)
}
