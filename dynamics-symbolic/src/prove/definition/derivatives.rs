//! Derivatives of inverse and forward dynamics.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::elimination::{pivots, solve};
use super::equations::sum;
use super::pose::{Lift, Position};
use super::state::State;
use super::{Definition, Matrix, Vector};

impl Definition {
    /// The Euler-Lagrange equations, d/dt (dT/dqd) - dT/dq + dU/dq: tau without friction.
    pub(super) fn euler_lagrange<R: Lift>(&self, motion: &State<R>) -> Vec<R> {
        let n = self.dof();
        let zero = R::lift(Number::ZERO);
        // d/dt: q changes at the rate qd, qd at the rate qdd.
        let moving = self.moving(&motion.q, &motion.qd);
        let rates = motion.qd.iter().zip(&motion.qdd);
        let speeds: Vec<_> = rates.map(|(&qd, &qdd)| Dual::new(qd, qdd)).collect();
        let rate = |qd: &[Dual<R>]| self.kinetic_energy(&moving, qd).derivative;
        let along_motion = rate(&speeds);
        let force = |i: usize| {
            // dT/dqd_i = T(qd + e_i) - T(qd) - T(e_i), for T is quadratic in qd.
            let unit = self.unit(i);
            let axis: Vec<_> = unit.iter().map(|&x| Dual::new(x, zero)).collect();
            let shifted: Vec<_> = speeds.iter().zip(&axis).map(|(&a, &b)| a + b).collect();
            let momentum_rate = rate(&shifted) - along_motion - rate(&axis);
            let displaced = self.moving(&motion.q, &unit);
            let still: Vec<_> = motion.qd.iter().map(|&x| Dual::new(x, zero)).collect();
            let kinetic = self.kinetic_energy(&displaced, &still).derivative;
            let potential = self.potential_energy(&displaced).derivative;
            momentum_rate - kinetic + potential
        };
        (0..n).map(force).collect()
    }

    /// The first derivative of tau by time, then the second one. Coulomb friction is constant.
    pub(super) fn inverse_dynamics_rates(&self) -> Vector {
        // Two dual numbers are two steps in time: x + x' e_1 + x' e_2 + x'' e_1 e_2.
        let jet = |x: &Vector, xd: &Vector, xdd: &Vector| -> Vec<_> {
            let entry = |i: usize| Dual::new(Dual::new(x[i], xd[i]), Dual::new(xd[i], xdd[i]));
            (0..self.dof()).map(entry).collect()
        };
        let force = self.euler_lagrange(&State {
            q: self.accelerating(),
            qd: jet(&self.qd, &self.qdd, &self.jerk),
            qdd: jet(&self.qdd, &self.jerk, &self.snap),
        });
        let first: Vector = force.iter().map(|x| x.derivative.value).collect();
        let second: Vector = force.iter().map(|x| x.derivative.derivative).collect();
        let [of_friction, second_of_friction] = self.rates_of_friction();
        [sum(&first, &of_friction), sum(&second, &second_of_friction)].concat()
    }

    /// The positions with two steps in time.
    pub(super) fn accelerating(&self) -> Vec<Position<Dual<Dual<Number>>>> {
        let rates = self.qd.iter().zip(&self.qdd);
        let speeds: Vec<_> = rates.map(|(&qd, &qdd)| Dual::new(qd, qdd)).collect();
        self.moving(&self.moving(&self.q, &self.qd), &speeds)
    }

    /// d tau/dq and d tau/dqd at accelerations qdd, by rows. Coulomb friction is constant.
    fn force_derivatives(&self, qdd: &[Number]) -> (Matrix, Matrix) {
        let friction = self.slopes_of_friction();
        let constant = |x: &[Number]| -> Vec<_> { x.iter().map(|&x| Dual::lift(x)).collect() };
        let still = |q: &Position<Number>| q.moving(Number::ZERO);
        let derivative = |motion: State<Dual<Number>>| -> Vector {
            let force = self.euler_lagrange(&motion);
            force.iter().map(|x| x.derivative).collect()
        };
        let by_position = |k: usize| {
            derivative(State {
                q: self.along(k),
                qd: constant(&self.qd),
                qdd: constant(qdd),
            })
        };
        let by_velocity = |k: usize| {
            let mut qd = constant(&self.qd);
            qd[k].derivative = Number::ONE;
            let mut column = derivative(State {
                q: self.q.iter().map(still).collect(),
                qd,
                qdd: constant(qdd),
            });
            column[k] = column[k] + friction[k];
            column
        };
        let n = self.dof();
        (
            transpose(&(0..n).map(by_position).collect()),
            transpose(&(0..n).map(by_velocity).collect()),
        )
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
        let n = self.dof();
        let matrix = self.mass_matrix(&self.q);
        let values = self.acceleration_derivatives(&matrix);
        let pivots = pivots(matrix.clone()).into_iter();
        let diagonal = (0..n).map(|i| Some(matrix[i][i]));
        let known = values.into_iter().chain(pivots).chain(diagonal);
        // What is not known is not read: anything that the program computes there is right.
        let expected = known.enumerate().map(|(k, known)| {
            let computed = computed.get(k).copied().flatten();
            known.or(computed).unwrap_or(Number::ZERO)
        });
        expected.collect()
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
        let right_sides = [negative(&by_position), negative(&by_velocity), identity(n)];
        let solutions = right_sides.into_iter().filter_map(solve);
        solutions.flat_map(|x| x.concat()).map(Some).collect()
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

fn identity(n: usize) -> Matrix {
    let entry = |i, j| if i == j { Number::ONE } else { Number::ZERO };
    (0..n)
        .map(|i| (0..n).map(|j| entry(i, j)).collect())
        .collect()
}
