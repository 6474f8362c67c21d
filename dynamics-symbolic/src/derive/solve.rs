//! The mass matrix, factored from the tips inwards.
//!
//! M = U D U^T with U unit upper triangular: d_j is the inertia that joint j
//! feels when the joints outside it are free (the articulated inertia of its
//! axis), so that the relative pivot d_j / M_jj says how near joint j is to
//! losing its inertia. An entry of joints of which neither carries the other is zero in M, and stays zero in U: what
//! is taken out of a joint's row is shared among the joints that carry it (Featherstone 2008, 6.5).
//!
//! The computed x solves a system beside M to rounding, however nearly singular M is (Higham 2002,
//! 10.1), because its entries share their errors: the factors are of one matrix, and each x_j makes
//! good what the x_i before it are, not what they should be. An equal definition that reads
//! something else would lose that, so that all definitions are held.
//!
//! M is factored from the tip inwards: its pivots are then the inertias that each joint feels with the joints outside
//! it free, and `SingularMassMatrix` can name the joint. Factoring takes operations that grow with the cube of the
//! number of joints, articulated bodies about 470 a joint for a generic chain. The shorter form is emitted. A form
//! that is longer by a tenth in the plain gauge is not searched. `tests/golden/forward_dynamics.txt` and
//! `forward_dynamics_of_long_chains.txt` have the counts of both.

use crate::expr::{Expr, Graph};
use crate::linear::eliminate;

type Matrix<'g> = Vec<Vec<Expr<'g>>>;

/// The factors of M, unrolled; entries that are zero cost nothing.
pub(super) struct Factors<'g> {
    graph: &'g Graph,
    /// U above the diagonal.
    upper: Matrix<'g>,
    /// d
    pivots: Vec<Expr<'g>>,
    /// 1 / d
    reciprocals: Vec<Expr<'g>>,
    /// Whether nothing was taken out of a joint's pivot.
    outermost: Vec<bool>,
}

impl<'g> Factors<'g> {
    /// Factors a symmetric matrix, and solves M x = b on the way. `outermost` are the joints that carry no other.
    pub(super) fn new(
        graph: &'g Graph,
        outermost: Vec<bool>,
        mut m: Matrix<'g>,
        mut b: Vec<Expr<'g>>,
    ) -> (Self, Vec<Expr<'g>>) {
        let n = m.len();
        let mut reciprocals = vec![graph.zero(); n];
        for j in (0..n).rev() {
            let step = || take_out(graph, &mut m, &mut b, j);
            reciprocals[j] = hold_unless(outermost[j], graph, step);
        }
        let factors = Factors {
            graph,
            pivots: (0..n).map(|j| m[j][j]).collect(),
            upper: m,
            reciprocals,
            outermost,
        };
        let x = graph.holding(|| factors.solve_lower(&b));
        (factors, x)
    }

    /// d
    pub(super) fn pivots(&self) -> &[Expr<'g>] {
        &self.pivots
    }

    /// The solution of M x = b.
    pub(super) fn solve(&self, b: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
        let b = self.solve_upper(b);
        self.graph.holding(|| self.solve_lower(&b))
    }

    /// The solution of U x = b.
    fn solve_upper(&self, mut b: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
        let n = b.len();
        for j in (0..n).rev() {
            hold_unless(self.outermost[j], self.graph, || {
                for i in (0..j).rev() {
                    b[i] = b[i] - self.upper[i][j] * b[j];
                }
            });
        }
        b
    }

    /// The solution of D U^T x = b.
    fn solve_lower(&self, b: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let mut x: Vec<Expr<'g>> = Vec::with_capacity(b.len());
        for j in 0..b.len() {
            let own = b[j] * self.reciprocals[j];
            let coupled = (0..j).fold(own, |sum, i| sum - self.upper[i][j] * x[i]);
            x.push(coupled);
        }
        x
    }

    /// B' M^-1 B for a matrix B by columns: with X = U^-1 B, X' D^-1 X.
    pub(super) fn congruence(&self, columns: &[Vec<Expr<'g>>]) -> Matrix<'g> {
        let zero = self.graph.zero();
        let reduced: Vec<_> = columns
            .iter()
            .map(|b| self.solve_upper(b.clone()))
            .collect();
        let weighted = |x: &Vec<Expr<'g>>| -> Vec<_> {
            let terms = x.iter().zip(&self.reciprocals);
            terms.map(|(&x, &reciprocal)| reciprocal * x).collect()
        };
        let dot = |a: &[Expr<'g>], b: &[Expr<'g>]| {
            let terms = a.iter().zip(b);
            terms.fold(zero, |sum, (&a, &b)| sum + a * b)
        };
        let mut product = vec![vec![zero; columns.len()]; columns.len()];
        for (i, x) in reduced.iter().enumerate() {
            let x = weighted(x);
            for j in i..columns.len() {
                product[i][j] = dot(&x, &reduced[j]);
                product[j][i] = product[i][j];
            }
        }
        product
    }

    /// The inverse of M: with W = U^-1, M^-1 = W^T D^-1 W.
    pub(super) fn inverse(&self) -> Matrix<'g> {
        let n = self.pivots.len();
        let w = self.inverse_upper();
        let zero = self.graph.zero();
        let mut inverse = vec![vec![zero; n]; n];
        for i in 0..n {
            for j in i..n {
                let terms = (0..=i).map(|k| w[k][i] * (self.reciprocals[k] * w[k][j]));
                inverse[i][j] = terms.fold(zero, |sum, term| sum + term);
                inverse[j][i] = inverse[i][j];
            }
        }
        inverse
    }

    /// U^-1, by U U^-1 = 1 from the last row upwards.
    fn inverse_upper(&self) -> Matrix<'g> {
        let n = self.pivots.len();
        let mut w = vec![vec![self.graph.zero(); n]; n];
        for i in (0..n).rev() {
            w[i][i] = self.graph.one();
            for j in i + 1..n {
                for k in i + 1..=j {
                    w[i][j] = w[i][j] - self.upper[i][k] * w[k][j];
                }
            }
        }
        w
    }
}

/// Takes joint j out of the equations, and returns 1 / d_j; b becomes U^-1 b.
fn take_out<'g>(graph: &'g Graph, m: &mut Matrix<'g>, b: &mut [Expr<'g>], j: usize) -> Expr<'g> {
    let reciprocal = graph.one() / m[j][j];
    eliminate(m, j, |x| x * reciprocal);
    for i in (0..j).rev() {
        b[i] = b[i] - m[i][j] * b[j];
    }
    reciprocal
}

/// The step of a joint that carries no other is held by nothing: its pivot is an entry of M and no difference, so
/// that its results are as accurate however they are written.
fn hold_unless<T>(is_outermost: bool, graph: &Graph, step: impl FnOnce() -> T) -> T {
    if is_outermost {
        step()
    } else {
        graph.holding(step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Level;

    fn outermost() -> Vec<bool> {
        vec![false, false, false, true]
    }

    fn symmetric(graph: &Graph) -> Matrix<'_> {
        let mut m = vec![vec![graph.zero(); 4]; 4];
        for i in 0..4 {
            for j in 0..=i {
                m[i][j] = graph.symbol(Level::Variable);
                m[j][i] = m[i][j];
            }
        }
        m
    }

    fn times<'g>(m: &Matrix<'g>, x: &[Expr<'g>], zero: Expr<'g>) -> Vec<Expr<'g>> {
        let dot = |row: &Vec<Expr<'g>>| row.iter().zip(x).fold(zero, |sum, (&m, &x)| sum + m * x);
        m.iter().map(dot).collect()
    }

    #[test]
    fn a_solution_satisfies_its_equations() {
        let graph = Graph::new();
        let m = symmetric(&graph);
        let b: Vec<_> = (0..4).map(|_| graph.symbol(Level::Variable)).collect();
        let (factors, x) = Factors::new(&graph, outermost(), m.clone(), b.clone());
        assert_eq!(times(&m, &x, graph.zero()), b);
        assert_eq!(factors.solve(b), x);
    }

    /// Joints 1 and 2 stand on link 0, joint 3 on link 2.
    #[test]
    fn nothing_is_filled_in_between_branches() {
        let graph = Graph::new();
        let mut m = symmetric(&graph);
        for (i, j) in [(1, 2), (1, 3)] {
            (m[i][j], m[j][i]) = (graph.zero(), graph.zero());
        }
        let outermost = vec![false, true, false, true];
        let (factors, _) = Factors::new(&graph, outermost, m, vec![graph.one(); 4]);
        let is_zero = |(i, j): &(usize, usize)| factors.upper[*i][*j].is_zero();
        let above = (0..4).flat_map(|i| (i + 1..4).map(move |j| (i, j)));
        assert_eq!(above.filter(is_zero).collect::<Vec<_>>(), [(1, 2), (1, 3)]);
    }

    #[test]
    fn the_matrix_times_its_inverse_is_one() {
        let graph = Graph::new();
        let m = symmetric(&graph);
        let b = vec![graph.zero(); 4];
        let inverse = Factors::new(&graph, outermost(), m.clone(), b).0.inverse();
        for j in 0..4 {
            let column: Vec<_> = inverse.iter().map(|row| row[j]).collect();
            let unit = (0..4).map(|i| if i == j { graph.one() } else { graph.zero() });
            assert_eq!(times(&m, &column, graph.zero()), unit.collect::<Vec<_>>());
        }
    }
}
