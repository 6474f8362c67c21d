//! Forward dynamics by factoring the mass matrix from the tip inwards.
//!
//! M = U D U^T with U unit upper triangular: d_j is the inertia that joint j
//! feels when the joints outside it are free (the articulated inertia of its
//! axis), so that the relative pivot d_j / M_jj says how near joint j is to
//! losing its inertia.

use crate::expr::{Expr, Graph};

/// The solution of M x = b, and the pivots d.
pub(super) struct Solution<'g> {
    /// x
    pub(super) x: Vec<Expr<'g>>,
    /// d
    pub(super) pivots: Vec<Expr<'g>>,
}

/// Solves M x = b, unrolled; entries that are zero cost nothing.
pub(super) fn solve<'g>(
    graph: &'g Graph,
    mut m: Vec<Vec<Expr<'g>>>,
    mut b: Vec<Expr<'g>>,
) -> Solution<'g> {
    let n = b.len();
    let mut reciprocals = vec![graph.zero(); n];
    // m[i][j], i < j, becomes U_ij; m[j][j] becomes d_j; b becomes U^-1 b.
    for j in (0..n).rev() {
        reciprocals[j] = graph.one() / m[j][j];
        for i in (0..j).rev() {
            let u = m[i][j] * reciprocals[j];
            for k in 0..=i {
                m[k][i] = m[k][i] - u * m[k][j];
            }
            b[i] = b[i] - u * b[j];
        }
        for i in 0..j {
            m[i][j] = m[i][j] * reciprocals[j];
        }
    }
    let mut x: Vec<Expr<'g>> = Vec::with_capacity(n);
    for j in 0..n {
        let coupled = (0..j).fold(b[j] * reciprocals[j], |sum, i| sum - m[i][j] * x[i]);
        x.push(coupled);
    }
    Solution {
        x,
        pivots: (0..n).map(|j| m[j][j]).collect(),
    }
}
