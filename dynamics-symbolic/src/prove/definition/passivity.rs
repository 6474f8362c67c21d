//! M qdd_r + C(q, qd) qd_r + G + F with C_ij = sum c_ijk qd_k, and the same of a unit of each base
//! parameter.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::equations::{product, sum};
use super::pose::{Lift, Position};
use super::twist::{Twist, polar, twist};
use super::{Definition, Matrix, Vector};
use crate::linear::Vector3;

/// For each pair of joints, link and parameter.
type Forms<R> = Vec<Vec<Vec<[R; 10]>>>;

impl Definition {
    /// M qdd_r + C qd_r + G + K + F
    pub(super) fn passivity_torque(&self) -> Vector {
        let inertial = product(&self.mass_matrix(&self.q), &self.qdd_r);
        let coriolis = product(&self.coriolis_matrix(), &self.qd_r);
        let conservative = sum(&sum(&inertial, &coriolis), &self.gravity_vector());
        sum(&conservative, &self.joint_forces())
    }

    /// By rows; `None` where the table's forces are not those of its parameters.
    pub(super) fn passivity_regressor(&self) -> Option<Vector> {
        let kept = self.kept_parameters()?;
        let matrices = self.standard_matrices(&self.q);
        let slopes: Vec<Forms<Dual<Number>>> = (0..self.dof())
            .map(|k| self.standard_matrices(&self.along(k)))
            .collect();
        let row = |i: usize| {
            let weights = self.standard_slopes(i);
            let of_link = |link: usize| -> Vector {
                let force = |p: usize| {
                    let inertial = (0..self.dof()).map(|j| matrices[i][j][link][p] * self.qdd_r[j]);
                    let slope = |i: usize, j: usize, k: usize| slopes[k][i][j][link][p].derivative;
                    let christoffel =
                        |j, k| self.half * (slope(i, j, k) + slope(i, k, j) - slope(j, k, i));
                    let pairs = (0..self.dof()).flat_map(|j| (0..self.dof()).map(move |k| (j, k)));
                    let coriolis =
                        pairs.map(|(j, k)| christoffel(j, k) * self.qd[k] * self.qd_r[j]);
                    let terms = inertial.chain(coriolis);
                    terms.fold(weights[link][p], |sum, term| sum + term)
                };
                let motor = self.share_of_motor(link, i) * self.qdd_r[i];
                self.in_moment_axes(link, (0..10).map(force).collect(), motor)
            };
            let columns: Vector = (0..self.rows.len()).flat_map(of_link).collect();
            kept.iter()
                .map(|&column| columns[column])
                .collect::<Vector>()
        };
        let rows: Matrix = (0..self.dof()).map(row).collect();
        Some(rows.concat())
    }

    /// M of a unit of each parameter: the energies of unit velocities, polarised.
    fn standard_matrices<R: Lift>(&self, q: &[Position<R>]) -> Forms<R> {
        let units: Vec<_> = (0..self.dof()).map(|j| self.unit_twists(q, j)).collect();
        let pair = |a: &Vec<Twist<R>>, b: &Vec<Twist<R>>| {
            let links = a.iter().zip(b);
            links.map(|(&a, &b)| polar(a, b)).collect()
        };
        let row = |a| units.iter().map(|b| pair(a, b)).collect();
        units.iter().map(row).collect()
    }

    /// The velocities of all links where joint j alone moves, at unit speed.
    fn unit_twists<R: Lift>(&self, q: &[Position<R>], j: usize) -> Vec<Twist<R>> {
        let frames = self.joint_frames(&self.moving(q, &self.unit(j)));
        frames.iter().map(twist).collect()
    }

    /// dU/dq_i of a unit of each parameter: U = -m g.p - g.R h.
    fn standard_slopes(&self, i: usize) -> Vec<[Number; 10]> {
        let frames = self.joint_frames(&self.along(i));
        let along = |v: [Dual<Number>; 3]| self.gravity.dot(Vector3(v.map(|x| x.derivative)));
        let slope = |frame: &super::pose::Pose<Dual<Number>>| {
            let mut slope = [Number::ZERO; 10];
            for k in 0..3 {
                slope[6 + k] = -along(frame.rotation.column(k).0);
            }
            slope[9] = -along(frame.origin.0);
            slope
        };
        frames.iter().map(slope).collect()
    }
}
