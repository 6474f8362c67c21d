//! Computed values beside exact ones.

use robot_dynamics::nalgebra::{SMatrix, SVector};
use testkit::references::Decimal;

/// Computed values of one function at one state beside their references.
pub(super) struct Quantity {
    pub(super) function: &'static str,
    /// The natural magnitude; 0 where every value must be zero exactly.
    scale: f64,
    pub(super) values: Vec<(f64, Decimal)>,
}

impl Quantity {
    pub(super) fn new(function: &'static str, scale: f64, values: Vec<(f64, Decimal)>) -> Self {
        Quantity {
            function,
            scale,
            values,
        }
    }

    /// The largest error over the scale; infinite where a value is NaN.
    pub(super) fn error(&self) -> f64 {
        let errors = self.values.iter().map(|(x, exact)| exact.error_of(*x));
        let relative = errors.map(|error| match error {
            0.0 => 0.0,
            _ if error.is_nan() => f64::INFINITY,
            _ => error.abs() / self.scale,
        });
        relative.fold(0.0, f64::max)
    }
}

/// The entries of a vector beside their references.
pub(super) fn vector<const N: usize>(
    computed: Option<SVector<f64, N>>,
    exact: &[Decimal],
) -> Vec<(f64, Decimal)> {
    let computed = computed.expect("the function was asked for");
    assert_eq!(exact.len(), N);
    computed
        .iter()
        .copied()
        .zip(exact.iter().copied())
        .collect()
}

/// The entries of a matrix, by rows, beside their references.
pub(super) fn matrix<const R: usize, const C: usize>(
    computed: Option<SMatrix<f64, R, C>>,
    exact: &[Vec<Decimal>],
) -> Vec<(f64, Decimal)> {
    let computed = computed.expect("the function was asked for");
    assert_eq!(exact.len(), R);
    (exact.iter().enumerate())
        .flat_map(|(i, row)| {
            row.iter()
                .enumerate()
                .map(move |(j, x)| (computed[(i, j)], *x))
        })
        .collect()
}

pub(super) fn sum(a: &[Decimal], b: &[Decimal]) -> Vec<Decimal> {
    a.iter().zip(b).map(|(a, b)| *a + *b).collect()
}

/// The largest absolute value.
pub(super) fn magnitude(values: &[Decimal]) -> f64 {
    values.iter().map(|x| x.nearest().abs()).fold(0.0, f64::max)
}
