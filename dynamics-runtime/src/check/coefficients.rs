//! The coefficients of V in the velocities.

use nalgebra::{SMatrix, SVector};

use super::deviation::{Entry, Measured, of};
use crate::NewtonEuler;

/// Entries of the difference of B(q): V is quadratic in qd, so that its polarisation
/// `V(e_j + e_k) - V(e_j) - V(e_k)` is the column of the pair (j, k).
///
/// A column that is missing or too many is not a number.
pub(super) fn coriolis_entries<T: Measured, const N: usize>(
    columns: &[SVector<T, N>],
    numeric: &NewtonEuler<N>,
    q: &SVector<f64, N>,
    scale: f64,
) -> impl Iterator<Item = Entry> {
    let squares = centrifugal_coefficients(numeric, q);
    let pairs = (0..N).flat_map(|j| (j + 1..N).map(move |k| (j, k)));
    let expected: Vec<SVector<T, N>> = pairs
        .map(|(j, k)| {
            let both = numeric.coriolis_vector(q, &(unit(j) + unit(k)));
            of(both - squares.column(j) - squares.column(k))
        })
        .collect();
    let missing = SVector::repeat(T::of(f64::NAN));
    let column = move |of: &[SVector<T, N>], pair: usize| of.get(pair).copied().unwrap_or(missing);
    (0..columns.len().max(expected.len())).flat_map(move |pair| {
        let difference = column(columns, pair) - column(&expected, pair);
        (0..N).map(move |joint| Entry::new(Some(joint), difference[joint], scale))
    })
}

/// C(q): column j is V at the unit velocity of joint j.
pub(super) fn centrifugal_coefficients<const N: usize>(
    numeric: &NewtonEuler<N>,
    q: &SVector<f64, N>,
) -> SMatrix<f64, N, N> {
    let mut coefficients = SMatrix::<f64, N, N>::zeros();
    for j in 0..N {
        coefficients.set_column(j, &numeric.coriolis_vector(q, &unit(j)));
    }
    coefficients
}

fn unit<const N: usize>(joint: usize) -> SVector<f64, N> {
    SVector::from_fn(|i, _| if i == joint { 1.0 } else { 0.0 })
}
