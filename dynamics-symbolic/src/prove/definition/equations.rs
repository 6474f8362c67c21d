//! The equations of motion, from the energies.

use super::super::assignment::{HALF, Number};
use super::super::dual::Dual;
use super::configuration::Configuration;
use super::friction::Velocity;
use super::pose::Lift;
use super::row::Row;
use super::{Definition, Matrix, Vector};
use crate::linear::Vector3;

impl Definition {
    /// d2T/dqd_i dqd_j, for T is quadratic in qd.
    pub(super) fn mass_matrix<R: Lift>(&self, q: &Configuration<R>) -> Vec<Vec<R>> {
        let units: Vec<_> = (0..self.dof())
            .map(|i| self.velocities(q, &self.unit(i)))
            .collect();
        let row = |x| units.iter().map(|y| self.inertia_form(x, y)).collect();
        units.iter().map(row).collect()
    }

    /// c_ijk, Christoffel symbols of the first kind, indexed `[i][j][k]`.
    pub(super) fn christoffel(&self) -> Vec<Matrix> {
        let n = self.dof();
        let matrices: Vec<_> = (0..n).map(|k| self.mass_matrix(&self.along(k))).collect();
        // dM_ij/dq_k
        let slope = |i: usize, j: usize, k: usize| matrices[k][i][j].derivative;
        let symbol = |i: usize, j: usize, k: usize| {
            HALF * (slope(i, j, k) + slope(i, k, j) - slope(j, k, i))
        };
        let row = |i, j| (0..n).map(|k| symbol(i, j, k)).collect();
        let matrix = |i| (0..n).map(|j| row(i, j)).collect();
        (0..n).map(matrix).collect()
    }

    /// dT/dqd
    pub(super) fn generalized_momentum(&self) -> Vector {
        let motion = self.velocities(&self.q, &self.qd);
        let momentum = |i| self.inertia_form(&motion, &self.velocities(&self.q, &self.unit(i)));
        (0..self.dof()).map(momentum).collect()
    }

    /// dT/dq - G - K - F: by Lagrange d/dt (dT/dqd) = tau + dT/dq - dU/dq - F. Hamel's terms of a base that moves
    /// are on the right side too.
    pub(super) fn momentum_bias(&self) -> Vector {
        let qd = constant(&self.qd);
        let slope = |i: usize| self.kinetic_energy(&self.along(i), &qd).derivative;
        let forces = sum(&self.gravity_vector(), &self.joint_forces());
        let turning = self.turning_of_base(&self.generalized_momentum(), &self.qd);
        let forces = sum(&forces, &turning);
        let forces = forces.into_iter().enumerate();
        forces.map(|(i, force)| slope(i) - force).collect()
    }

    /// d/dt (dT/dqd) - dT/dq, and Hamel's terms of a base that moves.
    fn inertial_forces<R: Lift>(&self, q: &Configuration<R>, qd: &[R], qdd: &[R]) -> Vec<R> {
        let zero = R::lift(Number::ZERO);
        // d/dt: q changes at the rate qd, qd at the rate qdd.
        let moving = self.moving(q, qd);
        let rates = qd.iter().zip(qdd);
        let speeds: Vec<_> = rates.map(|(&qd, &qdd)| Dual::new(qd, qdd)).collect();
        let motion = self.velocities(&moving, &speeds);
        let momentum =
            |i: usize| self.inertia_form(&motion, &self.velocities(&moving, &self.unit(i)));
        let momenta: Vec<Dual<R>> = (0..self.dof()).map(momentum).collect();
        let still: Vec<_> = qd.iter().map(|&x| Dual::new(x, zero)).collect();
        let slope = |i: usize| {
            let displaced = self.moving(q, &self.unit(i));
            self.kinetic_energy(&displaced, &still).derivative
        };
        let values: Vec<_> = momenta.iter().map(|momentum| momentum.value).collect();
        let turning = self.turning_of_base(&values, qd).into_iter().enumerate();
        turning
            .map(|(i, turning)| momenta[i].derivative - slope(i) + turning)
            .collect()
    }

    /// The terms that Hamel's equations add to d/dt (dT/du) for the axes of the base, which turn: w x dT/dv to the
    /// forces, and w x dT/dw + v x dT/dv to the moments (Hamel 1904; Kirchhoff's equations of a body by itself).
    fn turning_of_base<R: Lift>(&self, momenta: &[R], u: &[R]) -> Vec<R> {
        let mut forces = vec![R::lift(Number::ZERO); self.dof()];
        if let Some([v, w]) = self.velocity_of_base(u) {
            let momentum = |first: usize| Vector3([0, 1, 2].map(|k| momenta[first + k]));
            let (linear, angular) = (momentum(0), momentum(3));
            forces[..3].copy_from_slice(&w.cross(linear).0);
            forces[3..6].copy_from_slice(&(w.cross(angular) + v.cross(linear)).0);
        }
        forces
    }

    /// The Euler-Lagrange equations, d/dt (dT/dqd) - dT/dq + dU/dq: tau without friction.
    pub(super) fn euler_lagrange<R: Lift>(
        &self,
        q: &Configuration<R>,
        qd: &[R],
        qdd: &[R],
    ) -> Vec<R> {
        let slope = |i| {
            self.potential_energy(&self.moving(q, &self.unit(i)))
                .derivative
        };
        let inertial = self.inertial_forces(q, qd, qdd).into_iter().enumerate();
        inertial.map(|(i, force)| force + slope(i)).collect()
    }

    /// V = d/dt (dT/dqd) - dT/dq at qdd = 0, which is sum c_ijk qd_j qd_k.
    pub(super) fn coriolis_vector(&self) -> Vector {
        self.motion_forces(&self.q, &self.qd)
    }

    /// V of these velocities.
    pub(super) fn motion_forces<R: Lift>(&self, q: &Configuration<R>, qd: &[R]) -> Vec<R> {
        self.inertial_forces(q, qd, &constant(&vec![Number::ZERO; self.dof()]))
    }

    /// M qdd + V + G
    pub(super) fn link_forces(&self) -> Vector {
        let inertial = self.inertial_forces(&self.q, &self.qd, &self.qdd);
        sum(&inertial, &self.gravity_vector())
    }

    /// G = dU_g/dq
    pub(super) fn gravity_vector(&self) -> Vector {
        let component = |i| self.energy_of_gravity(&self.along(i)).derivative;
        (0..self.dof()).map(component).collect()
    }

    /// K = dU_k/dq
    pub(super) fn spring_vector(&self) -> Vector {
        let component = |i| self.energy_of_springs(&self.along(i)).derivative;
        (0..self.dof()).map(component).collect()
    }

    /// K + F, what acts at the joints themselves.
    fn joint_forces(&self) -> Vector {
        sum(&self.spring_vector(), &self.friction_vector())
    }

    /// V + G + K + F
    pub(super) fn bias_force(&self) -> Vector {
        self.inverse_dynamics(&vec![Number::ZERO; self.dof()])
    }

    /// tau = M qdd + V + G + K + F
    pub(super) fn inverse_dynamics(&self, qdd: &[Number]) -> Vector {
        let links_and_springs = self.euler_lagrange(&self.q, &self.qd, qdd);
        sum(&links_and_springs, &self.friction_vector())
    }

    /// M qdd_r + C qd_r + G + K + F
    pub(super) fn passivity_torque(&self) -> Vector {
        let inertial = product(&self.mass_matrix(&self.q), &self.qdd_r);
        let coriolis = product(&self.coriolis_matrix(), &self.qd_r);
        let conservative = sum(&sum(&inertial, &coriolis), &self.gravity_vector());
        sum(&conservative, &self.joint_forces())
    }

    /// C_ij = sum_k c_ijk qd_k; of a base that moves the sum of J' (I dJ/dt + B J), see `coriolis`.
    pub(super) fn coriolis_matrix(&self) -> Matrix {
        if self.floating.is_some() {
            return self.coriolis_matrix_of_bodies();
        }
        let symbols = self.christoffel();
        symbols.iter().map(|c| product(c, &self.qd)).collect()
    }

    /// By rows; columns (1,2), (1,3), ..., (n-1,n).
    pub(super) fn coriolis_coefficients(&self) -> Vector {
        let n = self.dof();
        let pairs = || (0..n).flat_map(|j| (j + 1..n).map(move |k| (j, k)));
        let row = |c: &Matrix| -> Vector { pairs().map(|(j, k)| c[j][k] + c[k][j]).collect() };
        self.christoffel().iter().flat_map(row).collect()
    }

    /// By rows; column j is the coefficient of qd_j^2.
    pub(super) fn centrifugal_coefficients(&self) -> Vector {
        let row = |c: &Matrix| -> Vector { (0..self.dof()).map(|j| c[j][j]).collect() };
        self.christoffel().iter().flat_map(row).collect()
    }
}

/// Numbers that do not change.
pub(super) fn constant<R: Lift>(x: &[Number]) -> Vec<R> {
    x.iter().map(|&x| R::lift(x)).collect()
}

pub(super) fn sum(a: &[Number], b: &[Number]) -> Vector {
    a.iter().zip(b).map(|(&a, &b)| a + b).collect()
}

pub(super) fn product(matrix: &Matrix, x: &[Number]) -> Vector {
    let dot = |row: &Vector| {
        let terms = row.iter().zip(x);
        terms.fold(Number::ZERO, |sum, (&m, &x)| sum + m * x)
    };
    matrix.iter().map(dot).collect()
}

impl Definition {
    /// F
    pub(super) fn friction_vector(&self) -> Vector {
        let force = |row: &Row| row.friction.force(&self.velocity(row));
        self.on_free_joints(self.rows.iter().map(force))
    }

    /// The diagonals of dF/dqd and d2F/dqd2: the derivatives of F along a motion of unit acceleration.
    pub(super) fn friction_derivatives(&self) -> [Vector; 2] {
        let [ones, zeros] = [Number::ONE, Number::ZERO].map(|x| vec![x; self.dof()]);
        self.friction_rates(&ones, &zeros)
    }

    /// The first and the second derivative of F along a motion with these accelerations and jerks.
    pub(super) fn friction_rates(&self, qdd: &[Number], jerk: &[Number]) -> [Vector; 2] {
        let rates = |row: &Row| {
            let rates = [row.joint.speed(qdd), row.joint.speed(jerk)];
            row.friction.rates(&self.velocity(row), rates)
        };
        let (first, second): (Vector, Vector) = self.rows.iter().map(rates).unzip();
        [first, second].map(|forces| self.on_free_joints(forces.into_iter()))
    }

    fn velocity(&self, row: &Row) -> Velocity<Number> {
        Velocity {
            qd: row.joint.speed(&self.qd),
            sign: row.joint.sign,
            exponential: row.joint.exponential,
        }
    }
}
