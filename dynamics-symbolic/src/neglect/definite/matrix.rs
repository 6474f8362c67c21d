//! Matrices of any size over any ring, and what is asked of symmetric ones.

use crate::linear::Ring;

/// By rows.
pub(super) type Matrix<R> = Vec<Vec<R>>;

pub(super) fn identity<R: Ring>(n: usize, zero: R, one: R) -> Matrix<R> {
    let entry = |i, k| if i == k { one } else { zero };
    (0..n)
        .map(|i| (0..n).map(|k| entry(i, k)).collect())
        .collect()
}

pub(super) fn transpose<R: Ring>(a: &Matrix<R>) -> Matrix<R> {
    let columns = 0..a.first().map_or(0, Vec::len);
    columns
        .map(|k| a.iter().map(|row| row[k]).collect())
        .collect()
}

pub(super) fn product<R: Ring>(a: &Matrix<R>, b: &Matrix<R>) -> Matrix<R> {
    let columns = transpose(b);
    let dot = |a: &Vec<R>, b: &Vec<R>| {
        let terms = a.iter().zip(b).map(|(&a, &b)| a * b);
        terms.reduce(|a, b| a + b).expect("no empty matrices")
    };
    let row = |row| columns.iter().map(|column| dot(row, column)).collect();
    a.iter().map(row).collect()
}

/// T^T A T
pub(super) fn congruent<R: Ring>(a: &Matrix<R>, t: &Matrix<R>) -> Matrix<R> {
    product(&transpose(t), &product(a, t))
}

/// A with `change` of each of its entries and those of B; B may be smaller.
pub(super) fn combined<R: Ring>(
    mut a: Matrix<R>,
    b: &Matrix<R>,
    change: impl Fn(R, R) -> R,
) -> Matrix<R> {
    for (a, b) in a.iter_mut().zip(b) {
        for (a, &b) in a.iter_mut().zip(b) {
            *a = change(*a, b);
        }
    }
    a
}
