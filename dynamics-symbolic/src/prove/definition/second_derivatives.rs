//! Second derivatives of inverse dynamics.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::pose::Lift;
use super::state::State;
use super::{Definition, Matrix, Vector};

/// Dual numbers over dual numbers: x + x_j e_1 + x_k e_2 + x_jk e_1 e_2.
type Twice = Dual<Dual<Number>>;

impl Definition {
    /// d2 tau_i/dq_j dq_k, d2 tau_i/dqd_j dqd_k, d2 tau_i/dq_j dqd_k and dM_ij/dq_k: for each of them i,
    /// then j, then k. Coulomb friction is constant.
    pub(super) fn second_derivatives(&self) -> Vector {
        let n = self.dof();
        let symbols = self.christoffel();
        let pairs: Vec<Vec<Pair>> = (0..n)
            .map(|j| (0..=j).map(|k| self.along_both(j, k)).collect())
            .collect();
        let pair = |j: usize, k: usize| &pairs[j.max(k)][j.min(k)];
        let curvatures = self.curvatures_of_friction();
        let by_velocity = |i: usize, j: usize, k: usize| {
            // V_i = sum c_ijk qd_j qd_k
            let motion = symbols[i][j][k] + symbols[i][k][j];
            match i == j && j == k {
                true => motion + curvatures[i],
                false => motion,
            }
        };
        // d2 V_i/dq_j dqd_k = 2 sum dc_ikm/dq_j qd_m, from the second derivatives of M.
        let by_both = |i: usize, j: usize, k: usize| {
            let term = |m: usize| {
                let slope = |a: usize, b: usize, c: usize| pair(j, c).inertia[a][b];
                (slope(i, k, m) + slope(i, m, k) - slope(k, m, i)) * self.qd[m]
            };
            (0..n).fold(Number::ZERO, |sum, m| sum + term(m))
        };
        let by_position = |i: usize, j: usize, k: usize| pair(j, k).forces[i];
        let of_inertia = |i: usize, j: usize, k: usize| symbols[i][j][k] + symbols[j][i][k];
        [
            entries(n, by_position),
            entries(n, by_velocity),
            entries(n, by_both),
            entries(n, of_inertia),
        ]
        .concat()
    }

    fn along_both(&self, j: usize, k: usize) -> Pair {
        let q = self.moving(&self.moving(&self.q, &self.unit(j)), &self.unit(k));
        let constant = |x: &Vector| x.iter().map(|&x| Twice::lift(x)).collect();
        let inertia = self.mass_matrix(&q);
        let forces = self.euler_lagrange(&State {
            q,
            qd: constant(&self.qd),
            qdd: constant(&self.qdd),
        });
        let mixed = |row: &Vec<Twice>| row.iter().map(|x| x.derivative.derivative).collect();
        Pair {
            inertia: inertia.iter().map(mixed).collect(),
            forces: mixed(&forces),
        }
    }
}

/// Second derivatives by the positions of two joints.
struct Pair {
    /// Of M.
    inertia: Matrix,
    /// Of tau.
    forces: Vector,
}

/// All entries, the last index first to change.
fn entries(n: usize, entry: impl Fn(usize, usize, usize) -> Number) -> Vector {
    let of_index = |index: usize| entry(index / (n * n), index / n % n, index % n);
    (0..n * n * n).map(of_index).collect()
}
