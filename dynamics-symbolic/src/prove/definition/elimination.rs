//! Forward dynamics: accelerations, and the pivots of the elimination that finds them.
//!
//! The derivations factor M by [`crate::linear::eliminate`]. Here it is done again, by rows and without
//! symmetry: what is proven shares no algorithm with its definition.

use super::super::assignment::Number;
use super::{Definition, Matrix, Vector};

impl Definition {
    /// Accelerations, pivots, and the diagonal of M.
    ///
    /// The accelerations are right if they satisfy the equations of motion. Where
    /// M is identically singular there are none, and the pivots up to the first
    /// zero are all that the generated function reads.
    pub(super) fn forward_dynamics(&self, computed: &[Option<Number>]) -> Vector {
        let n = self.dof();
        if computed.len() != 3 * n {
            return Vec::new();
        }
        let known = computed[..n].iter().map(|x| x.unwrap_or(Number::ZERO));
        let accelerations: Vector = known.collect();
        let matrix = self.mass_matrix(&self.q);
        let is_singular = pivots(matrix.clone()).contains(&Some(Number::ZERO));
        let is_right = is_singular || self.inverse_dynamics(&accelerations) == self.tau;
        let wrong = |&x: &Number| (!is_right).then_some(x + Number::ONE);
        let values = accelerations.iter().map(wrong).collect();
        with_pivots(values, matrix, computed)
    }
}

/// The values of what is solved for with M, the pivots and the diagonal of M. A value that is not known is not
/// read: whatever the program computes there is right.
pub(super) fn with_pivots(
    values: Vec<Option<Number>>,
    matrix: Matrix,
    computed: &[Option<Number>],
) -> Vector {
    let diagonal: Vec<_> = (0..matrix.len()).map(|i| Some(matrix[i][i])).collect();
    let known = values.into_iter().chain(pivots(matrix)).chain(diagonal);
    let expected = known.enumerate().map(|(k, known)| {
        let computed = computed.get(k).copied().flatten();
        known.or(computed).unwrap_or(Number::ZERO)
    });
    expected.collect()
}

/// The pivots of M = U D U^T, eliminated from the last row upwards; none after one that is zero.
pub(super) fn pivots(mut matrix: Matrix) -> Vec<Option<Number>> {
    let n = matrix.len();
    let mut pivots = vec![None; n];
    for j in (0..n).rev() {
        pivots[j] = Some(matrix[j][j]);
        let Some(inverse) = matrix[j][j].inverse() else {
            break;
        };
        for i in 0..j {
            let factor = matrix[i][j] * inverse;
            for k in 0..j {
                matrix[i][k] = matrix[i][k] - factor * matrix[j][k];
            }
        }
    }
    pivots
}

/// The solution X of M X = B, by elimination in the same order; none where a pivot is zero.
pub(super) fn solve(mut matrix: Matrix, mut b: Matrix) -> Option<Matrix> {
    let n = matrix.len();
    for j in (0..n).rev() {
        let inverse = matrix[j][j].inverse()?;
        matrix[j] = matrix[j].iter().map(|&x| x * inverse).collect();
        b[j] = b[j].iter().map(|&x| x * inverse).collect();
        for i in (0..n).filter(|&i| i != j) {
            let factor = matrix[i][j];
            matrix[i] = less(&matrix[i], factor, &matrix[j]);
            b[i] = less(&b[i], factor, &b[j]);
        }
    }
    Some(b)
}

/// a - factor b
fn less(a: &Vector, factor: Number, b: &Vector) -> Vector {
    a.iter().zip(b).map(|(&a, &b)| a - factor * b).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: &[&[u64]]) -> Matrix {
        let row = |row: &&[u64]| row.iter().map(|&x| Number::new(x)).collect();
        rows.iter().map(row).collect()
    }

    #[test]
    fn the_product_of_the_pivots_is_the_determinant() {
        let pivots = pivots(matrix(&[&[4, 2, 1], &[2, 5, 3], &[1, 3, 6]]));
        let product = pivots
            .iter()
            .fold(Number::ONE, |product, x| product * x.unwrap());
        assert_eq!(product, Number::new(67));
        assert_eq!(pivots[2], Some(Number::new(6)));
    }

    #[test]
    fn a_solution_satisfies_its_equations() {
        let m = matrix(&[&[4, 2, 1], &[2, 5, 3], &[1, 3, 6]]);
        let b = matrix(&[&[1, 7], &[2, 0], &[5, 3]]);
        let x = solve(m.clone(), b.clone()).unwrap();
        for (i, row) in m.iter().enumerate() {
            for k in 0..2 {
                let terms = (0..3).map(|j| row[j] * x[j][k]);
                assert_eq!(terms.fold(Number::ZERO, |sum, term| sum + term), b[i][k]);
            }
        }
        assert_eq!(
            solve(matrix(&[&[1, 2], &[2, 4]]), matrix(&[&[1], &[1]])),
            None
        );
    }

    #[test]
    fn a_zero_pivot_ends_the_elimination() {
        let pivots = pivots(matrix(&[&[1, 0, 0], &[0, 2, 4], &[0, 4, 8]]));
        assert_eq!(pivots, [None, Some(Number::ZERO), Some(Number::new(8))]);
    }
}
