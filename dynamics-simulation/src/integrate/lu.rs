//! Small systems of linear equations, real or complex.

use dynamics_runtime::Size;
use nalgebra::ComplexField;

/// A matrix as the product of a lower and an upper triangle, with rows exchanged so that each pivot
/// is the largest of its column (Golub and Van Loan, *Matrix Computations*, algorithm 3.4.1).
///
/// The solutions are not finite if a pivot is 0.
///
/// It is not nalgebra's: the bounds of its factorisations would stand in every signature up to the simulation's `run`.
#[derive(Clone)]
pub(crate) struct Lu<T: ComplexField + Copy, D: Size> {
    factors: D::Each<D::Each<T>>,
    rows: D::Each<usize>,
}

impl<T: ComplexField + Copy, D: Size> Lu<T, D> {
    /// Factors the matrix with these entries.
    pub(crate) fn new(size: D, entry: impl Fn(usize, usize) -> T) -> Self {
        let mut factors = size.each(|i| size.each(|j| entry(i, j)));
        let rows = size.each(|k| {
            let row = size.joints().skip(k + 1).fold(k, |best, i| {
                pivot(&factors[best][k], &factors[i][k], best, i)
            });
            factors.as_mut().swap(k, row);
            for i in k + 1..size.value() {
                let factor = factors[i][k] / factors[k][k];
                factors[i][k] = factor;
                for j in k + 1..size.value() {
                    let above = factors[k][j];
                    factors[i][j] -= factor * above;
                }
            }
            row
        });
        Lu { factors, rows }
    }

    #[inline]
    pub(crate) fn solve(&self, mut x: D::Each<T>) -> D::Each<T> {
        let size = x.as_ref().len();
        for (k, row) in self.rows.as_ref().iter().enumerate() {
            x.as_mut().swap(k, *row);
        }
        for i in 0..size {
            for j in 0..i {
                let known = x[j];
                x[i] -= self.factors[i][j] * known;
            }
        }
        for i in (0..size).rev() {
            for j in i + 1..size {
                let known = x[j];
                x[i] -= self.factors[i][j] * known;
            }
            x[i] /= self.factors[i][i];
        }
        x
    }
}

impl<D: Size> Lu<f64, D> {
    /// The solution for a vector of the joints.
    pub(crate) fn solve_vector(&self, b: &D::Vector) -> D::Vector {
        let size = D::of(b);
        let x = self.solve(size.each(|i| b[i]));
        size.vector_of(|i| x[i])
    }
}

/// The row of the greater of two entries.
fn pivot<T: ComplexField>(best: &T, other: &T, row: usize, other_row: usize) -> usize {
    if other.clone().norm1() > best.clone().norm1() {
        other_row
    } else {
        row
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Complex, Const, Matrix3, Vector3};

    use super::Lu;

    #[test]
    fn systems_are_solved_in_any_order_of_rows() {
        // The first pivot is 0.
        let a = Matrix3::new(0.0, 2.0, 1.0, -1.0, 3.0, 0.5, 4.0, 1.0, -2.0);
        let x = Vector3::new(1.0, -2.0, 3.0);
        let lu = Lu::new(Const::<3>, |i, j| a[(i, j)]);
        assert!((lu.solve_vector(&(a * x)) - x).amax() < 1e-15);
        let i = Complex::new(0.0, 1.0);
        let a = a.map(|entry| i * entry + 0.25);
        let x = x.map(|entry| Complex::new(entry, 1.0));
        let lu = Lu::new(Const::<3>, |i, j| a[(i, j)]);
        let solved = Vector3::from(lu.solve((a * x).into()));
        assert!((solved - x).map(|e| e.norm()).amax() < 1e-14);
    }
}
