//! Elimination in symmetric matrices of any size.

use super::Ring;

/// One step of M = U D U^T with U unit upper triangular, from the last row upwards: takes row and column j out of the
/// equations of those before them,
///
///   u_i = m_ij / d_j,   m_ki -= u_i m_kj   (k <= i < j).
///
/// Afterwards m_jj is the pivot d_j, and above it stands column j of U. `over_pivot` divides by d_j. Entries below the
/// diagonal are neither read nor written.
pub fn eliminate<R: Ring>(m: &mut [Vec<R>], j: usize, over_pivot: impl Fn(R) -> R) {
    let mut column = Vec::with_capacity(j);
    for i in (0..j).rev() {
        let u = over_pivot(m[i][j]);
        for row in &mut m[..=i] {
            row[i] = row[i] - u * row[j];
        }
        column.push(u);
    }
    for (row, u) in m.iter_mut().zip(column.into_iter().rev()) {
        row[j] = u;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Residue;

    type Number = Residue<{ (1 << 61) - 1 }>;

    #[test]
    fn the_factors_give_the_matrix() {
        let m = [[4, 2, 1], [2, 5, 3], [1, 3, 6]].map(|row| row.map(Number::new));
        let mut factors = m.map(|row| row.to_vec());
        for j in (0..3).rev() {
            let inverse = factors[j][j].inverse().expect("a pivot");
            eliminate(&mut factors, j, |x| x * inverse);
        }
        let u = |i: usize, j: usize| match i.cmp(&j) {
            core::cmp::Ordering::Less => factors[i][j],
            core::cmp::Ordering::Equal => Number::ONE,
            core::cmp::Ordering::Greater => Number::ZERO,
        };
        for i in 0..3 {
            for k in 0..3 {
                let terms = (0..3).map(|j| u(i, j) * factors[j][j] * u(k, j));
                assert_eq!(terms.fold(Number::ZERO, |sum, term| sum + term), m[i][k]);
            }
        }
    }
}
