//! Small systems of linear equations, real or complex.

use nalgebra::{ComplexField, SMatrix, SVector};

/// A matrix as the product of a lower and an upper triangle, with rows exchanged so that each pivot
/// is the largest of its column (Golub and Van Loan, *Matrix Computations*, algorithm 3.4.1).
///
/// Where a pivot is 0 the solutions are not finite. It is not nalgebra's, whose bound `Const<N>: DimMin<Const<N>>` would
/// stand in the signature of everything that is generic over the number of joints.
#[derive(Clone, Copy)]
pub(crate) struct Lu<T, const N: usize> {
    factors: SMatrix<T, N, N>,
    rows: [usize; N],
}

impl<T: ComplexField + Copy, const N: usize> Lu<T, N> {
    pub(crate) fn new(mut matrix: SMatrix<T, N, N>) -> Self {
        let mut rows = [0; N];
        for k in 0..N {
            rows[k] = pivot_row(&matrix, k);
            matrix.swap_rows(k, rows[k]);
            for i in k + 1..N {
                let factor = matrix[(i, k)] / matrix[(k, k)];
                matrix[(i, k)] = factor;
                for j in k + 1..N {
                    let above = matrix[(k, j)];
                    matrix[(i, j)] -= factor * above;
                }
            }
        }
        Lu {
            factors: matrix,
            rows,
        }
    }

    pub(crate) fn solve(&self, mut x: SVector<T, N>) -> SVector<T, N> {
        for (k, row) in self.rows.iter().enumerate() {
            x.swap_rows(k, *row);
        }
        for i in 0..N {
            for j in 0..i {
                let known = x[j];
                x[i] -= self.factors[(i, j)] * known;
            }
        }
        for i in (0..N).rev() {
            for j in i + 1..N {
                let known = x[j];
                x[i] -= self.factors[(i, j)] * known;
            }
            x[i] /= self.factors[(i, i)];
        }
        x
    }
}

/// The row of the largest entry of column `k` that is not yet eliminated.
fn pivot_row<T: ComplexField, const N: usize>(matrix: &SMatrix<T, N, N>, k: usize) -> usize {
    let size = |i: usize| matrix[(i, k)].clone().norm1();
    (k + 1..N).fold(k, |best, i| if size(i) > size(best) { i } else { best })
}

#[cfg(test)]
mod tests {
    use nalgebra::{Complex, Matrix3, Vector3};

    use super::Lu;

    #[test]
    fn systems_are_solved_in_any_order_of_rows() {
        // The first pivot is 0.
        let a = Matrix3::new(0.0, 2.0, 1.0, -1.0, 3.0, 0.5, 4.0, 1.0, -2.0);
        let x = Vector3::new(1.0, -2.0, 3.0);
        assert!((Lu::new(a).solve(a * x) - x).amax() < 1e-15);
        let i = Complex::new(0.0, 1.0);
        let a = a.map(|entry| i * entry + 0.25);
        let x = x.map(|entry| Complex::new(entry, 1.0));
        assert!((Lu::new(a).solve(a * x) - x).map(|e| e.norm()).amax() < 1e-14);
    }
}
