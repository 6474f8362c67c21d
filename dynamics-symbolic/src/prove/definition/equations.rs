//! The equations of motion, from the energies.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::axis::Axis;
use super::friction::Velocity;
use super::pose::{Lift, Position};
use super::row::Row;
use super::{Definition, Matrix, Vector};

impl Definition {
    /// d2T/dqd_i dqd_j = T(e_i + e_j) - T(e_i) - T(e_j), for T is quadratic in qd.
    pub(super) fn mass_matrix<R: Lift>(&self, q: &[Position<R>]) -> Vec<Vec<R>> {
        let n = self.dof();
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        let energy = |axes: &[usize]| {
            let mut qd = vec![zero; n];
            for &axis in axes {
                qd[axis] = one;
            }
            self.kinetic_energy(q, &qd)
        };
        let single: Vec<_> = (0..n).map(|i| energy(&[i])).collect();
        let mut matrix = vec![vec![zero; n]; n];
        for i in 0..n {
            matrix[i][i] = single[i] + single[i];
            for j in 0..i {
                matrix[i][j] = energy(&[i, j]) - single[i] - single[j];
                matrix[j][i] = matrix[i][j];
            }
        }
        matrix
    }

    /// dM/dq_k
    fn mass_matrix_slope(&self, k: usize) -> Matrix {
        let matrix = self.mass_matrix(&self.along(k));
        let slopes = |row: Vec<Dual<Number>>| row.iter().map(|x| x.derivative).collect();
        matrix.into_iter().map(slopes).collect()
    }

    /// c_ijk, Christoffel symbols of the first kind, indexed `[i][j][k]`.
    pub(super) fn christoffel(&self) -> Vec<Matrix> {
        let n = self.dof();
        let slopes: Vec<_> = (0..n).map(|k| self.mass_matrix_slope(k)).collect();
        let symbol = |i: usize, j: usize, k: usize| {
            self.half * (slopes[k][i][j] + slopes[j][i][k] - slopes[i][j][k])
        };
        let row = |i, j| (0..n).map(|k| symbol(i, j, k)).collect();
        let matrix = |i| (0..n).map(|j| row(i, j)).collect();
        (0..n).map(matrix).collect()
    }

    /// V = d/dt (dT/dqd) - dT/dq at qdd = 0, which is sum c_ijk qd_j qd_k.
    pub(super) fn coriolis_vector(&self) -> Vector {
        let moving = self.moving(&self.q, &self.qd);
        let rate = |qd: &[Number]| self.kinetic_energy(&moving, &constant(qd)).derivative;
        let still = rate(&self.qd);
        let component = |i: usize| {
            // dT/dqd_i = T(qd + e_i) - T(qd) - T(e_i); its rate along the motion.
            let mut unit = vec![Number::ZERO; self.dof()];
            unit[i] = Number::ONE;
            let momentum_rate = rate(&sum(&self.qd, &unit)) - still - rate(&unit);
            let slope = self.kinetic_energy(&self.along(i), &constant(&self.qd));
            momentum_rate - slope.derivative
        };
        (0..self.dof()).map(component).collect()
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
    pub(super) fn joint_forces(&self) -> Vector {
        sum(&self.spring_vector(), &self.friction_vector())
    }

    /// V + G + K + F
    pub(super) fn bias_force(&self) -> Vector {
        let of_links = sum(&self.coriolis_vector(), &self.gravity_vector());
        sum(&of_links, &self.joint_forces())
    }

    /// tau = M qdd + V + G + K + F
    pub(super) fn inverse_dynamics(&self, qdd: &[Number]) -> Vector {
        let inertial = product(&self.mass_matrix(&self.q), qdd);
        sum(&inertial, &self.bias_force())
    }

    /// C_ij = sum_k c_ijk qd_k
    pub(super) fn coriolis_matrix(&self) -> Matrix {
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

fn constant(x: &[Number]) -> Vec<Dual<Number>> {
    x.iter().map(|&x| Dual::lift(x)).collect()
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
        let of_axis =
            |(axis, row): (&Axis, &Row)| row.friction.force(&self.velocity(axis), self.half);
        self.felt(self.axes().map(of_axis))
    }

    /// The diagonal of dF/dqd.
    pub(super) fn slopes_of_friction(&self) -> Vector {
        // The velocity of an axis changes by its factor.
        let of_axis = |(axis, row): (&Axis, &Row)| {
            axis.factor * row.friction.slope(&self.velocity(axis), self.half)
        };
        self.felt(self.axes().map(of_axis))
    }

    /// The first and the second derivative of F along the motion.
    pub(super) fn rates_of_friction(&self) -> [Vector; 2] {
        let of_axis = |(axis, row): (&Axis, &Row)| {
            let rates = [axis.speed(&self.qdd), axis.speed(&self.jerk)];
            row.friction.rates(&self.velocity(axis), rates, self.half)
        };
        let (first, second): (Vector, Vector) = self.axes().map(of_axis).unzip();
        [first, second].map(|of_axes| self.felt(of_axes.into_iter()))
    }

    /// The diagonal of d2F/dqd2: the second derivative along a motion of unit acceleration.
    pub(super) fn curvatures_of_friction(&self) -> Vector {
        let unit = vec![Number::ONE; self.dof()];
        let of_axis = |(axis, row): (&Axis, &Row)| {
            let rates = [axis.speed(&unit), Number::ZERO];
            row.friction.rates(&self.velocity(axis), rates, self.half).1
        };
        self.felt(self.axes().map(of_axis))
    }

    fn velocity(&self, axis: &Axis) -> Velocity<Number> {
        Velocity {
            qd: axis.speed(&self.qd),
            sign: axis.sign,
            exponential: axis.exponential,
        }
    }
}
