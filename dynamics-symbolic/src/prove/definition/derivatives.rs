//! Derivatives of inverse and forward dynamics.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::configuration::Configuration;
use super::elimination::{solve, with_pivots};
use super::equations::{constant, sum};
use super::pose::Lift;
use super::{Definition, Matrix, Vector};

impl Definition {
    /// The first derivative of tau by time, then the second one. Coulomb friction is constant.
    pub(super) fn inverse_dynamics_rates(&self) -> Vector {
        // Two dual numbers are two steps in time: x + x' e_1 + x' e_2 + x'' e_1 e_2.
        let jet = |x: &Vector, xd: &Vector, xdd: &Vector| -> Vec<_> {
            let entry = |i: usize| Dual::new(Dual::new(x[i], xd[i]), Dual::new(xd[i], xdd[i]));
            (0..self.dof()).map(entry).collect()
        };
        let qd = jet(&self.qd, &self.qdd, &self.jerk);
        let qdd = jet(&self.qdd, &self.jerk, &self.snap);
        let force = self.euler_lagrange(&self.accelerating(), &qd, &qdd);
        let first: Vector = force.iter().map(|x| x.derivative.value).collect();
        let second: Vector = force.iter().map(|x| x.derivative.derivative).collect();
        let [of_friction, second_of_friction] = self.friction_rates(&self.qdd, &self.jerk);
        [sum(&first, &of_friction), sum(&second, &second_of_friction)].concat()
    }

    /// d tau/dq and d tau/dqd at accelerations qdd, by rows. Coulomb friction is constant.
    fn force_derivatives(&self, qdd: &[Number]) -> (Matrix, Matrix) {
        let [friction, _] = self.friction_derivatives();
        let (qd, qdd) = (constant(&self.qd), constant(qdd));
        let derivative = |q: &Configuration<_>, qd: &[_]| -> Vector {
            let force = self.euler_lagrange(q, qd, &qdd);
            force.iter().map(|x: &Dual<_>| x.derivative).collect()
        };
        let still = self.moving(&self.q, &vec![Number::ZERO; self.dof()]);
        let by_position = |k: usize| derivative(&self.along(k), &qd);
        let by_velocity = |k: usize| {
            let mut qd: Vec<Dual<_>> = qd.clone();
            qd[k].derivative = Number::ONE;
            let mut column = derivative(&still, &qd);
            column[k] = column[k] + friction[k];
            column
        };
        (self.by_columns(by_position), self.by_columns(by_velocity))
    }

    /// The matrix of these columns, one for each degree of freedom.
    pub(super) fn by_columns(&self, column: impl Fn(usize) -> Vector) -> Matrix {
        transpose(&(0..self.dof()).map(column).collect())
    }

    /// d tau/dq, then d tau/dqd.
    pub(super) fn inverse_dynamics_derivatives(&self) -> Vector {
        let (by_position, by_velocity) = self.force_derivatives(&self.qdd);
        [by_position.concat(), by_velocity.concat()].concat()
    }

    /// d qdd/dq, d qdd/dqd, d qdd/d tau, pivots, and the diagonal of M.
    ///
    /// M qdd + V + G + K + F = tau holds for every q, qd and tau: its derivatives are
    /// M d qdd/dq + d tau/dq = 0, M d qdd/dqd + d tau/dqd = 0, M d qdd/d tau = 1. Where M is
    /// identically singular there are none, as for the forward dynamics.
    pub(super) fn forward_dynamics_derivatives(&self, computed: &[Option<Number>]) -> Vector {
        let matrix = self.mass_matrix(&self.q);
        let values = self.acceleration_derivatives(&matrix);
        with_pivots(values, matrix, computed)
    }

    /// d qdd/dq, d qdd/dqd, d qdd/d tau by rows; unknown where M is singular.
    fn acceleration_derivatives(&self, matrix: &Matrix) -> Vec<Option<Number>> {
        let n = self.dof();
        let solve = |b: Matrix| solve(matrix.clone(), b);
        let net = self.tau.iter().zip(self.bias_force());
        let net = net.map(|(&tau, bias)| vec![tau - bias]).collect();
        let Some(qdd) = solve(net) else {
            return vec![None; 3 * n * n];
        };
        let (by_position, by_velocity) = self.force_derivatives(&qdd.concat());
        let identity = (0..n).map(|k| self.unit(k)).collect();
        let right_sides = [negative(&by_position), negative(&by_velocity), identity];
        let solutions = right_sides.into_iter().filter_map(solve);
        solutions.flat_map(|x| x.concat()).map(Some).collect()
    }

    /// d2 tau_i/dq_j dq_k, d2 tau_i/dqd_j dqd_k, d2 tau_i/dq_j dqd_k and dM_ij/dq_k: for each of them i,
    /// then j, then k. Coulomb friction is constant.
    pub(super) fn second_derivatives(&self) -> Vector {
        let n = self.dof();
        let by_positions: Vec<Vec<Vector>> = (0..n)
            .map(|j| (0..=j).map(|k| self.force_by_positions(j, k)).collect())
            .collect();
        let by_position = |i: usize, j: usize, k: usize| by_positions[j.max(k)][j.min(k)][i];
        let by_velocities = self.slopes_of_motion_forces(&self.q, &self.unit_velocities());
        let [_, curvatures] = self.friction_derivatives();
        let by_velocity = |i: usize, j: usize, k: usize| {
            let motion = by_velocities[j][k][i];
            if i == j && j == k {
                motion + curvatures[i]
            } else {
                motion
            }
        };
        let slopes = |j: usize| self.slopes_of_motion_forces(&self.along(j), &[constant(&self.qd)]);
        let by_both: Vec<_> = (0..n).map(|j| slopes(j).remove(0)).collect();
        let by_both = |i: usize, j: usize, k: usize| by_both[j][k][i].derivative;
        let matrices: Vec<_> = (0..n).map(|k| self.mass_matrix(&self.along(k))).collect();
        let inertia_slope = |i: usize, j: usize, k: usize| matrices[k][i][j].derivative;
        [
            entries(n, by_position),
            entries(n, by_velocity),
            entries(n, by_both),
            entries(n, inertia_slope),
        ]
        .concat()
    }

    /// d2 tau/dq_j dq_k
    fn force_by_positions(&self, j: usize, k: usize) -> Vector {
        let q = self.along_both(j, k);
        let forces = self.euler_lagrange(&q, &constant(&self.qd), &constant(&self.qdd));
        forces.iter().map(|x| x.derivative.derivative).collect()
    }

    fn unit_velocities(&self) -> Vec<Vector> {
        (0..self.dof()).map(|k| self.unit(k)).collect()
    }

    /// dV/dqd_k at each of some velocities: V(qd + e_k) - V(qd) - V(e_k), for V is quadratic in qd.
    fn slopes_of_motion_forces<R: Lift>(
        &self,
        q: &Configuration<R>,
        velocities: &[Vec<R>],
    ) -> Vec<Vec<Vec<R>>> {
        let forces = |qd: &[R]| self.motion_forces(q, qd);
        let units: Vec<Vec<R>> = (0..self.dof()).map(|k| self.unit(k)).collect();
        let of_units: Vec<_> = units.iter().map(|unit| forces(unit)).collect();
        let at = |qd: &Vec<R>| {
            let here = forces(qd);
            let slope = |k: usize| {
                let shifted: Vec<_> = qd.iter().zip(&units[k]).map(|(&a, &b)| a + b).collect();
                let terms = forces(&shifted).into_iter().zip(&here).zip(&of_units[k]);
                terms.map(|((sum, &a), &b)| sum - a - b).collect()
            };
            (0..self.dof()).map(slope).collect()
        };
        velocities.iter().map(at).collect()
    }
}

pub(super) fn transpose(m: &Matrix) -> Matrix {
    let columns = m.first().map_or(0, Vec::len);
    let column = |i: usize| m.iter().map(|row| row[i]).collect();
    (0..columns).map(column).collect()
}

fn negative(m: &Matrix) -> Matrix {
    m.iter()
        .map(|row| row.iter().map(|&x| -x).collect())
        .collect()
}

/// All entries, the last index first to change.
fn entries(n: usize, entry: impl Fn(usize, usize, usize) -> Number) -> Vector {
    let indices = (0..n * n * n).map(|k| (k / (n * n), k / n % n, k % n));
    indices.map(|(i, j, k)| entry(i, j, k)).collect()
}
