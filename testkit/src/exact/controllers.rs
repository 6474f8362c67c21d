//! Functions for controllers, from their definitions. Derivatives by time are differences in 31 digits.

use robot_dynamics::DoubleDouble;
use robot_dynamics::SecondDerivatives;
use robot_dynamics::nalgebra::{Matrix6, SMatrix, SVector, Vector6};
use robot_dynamics::table::JointType;

use super::{Exact, Link, Vector, number, solve};

type Joints<const N: usize> = SVector<DoubleDouble, N>;
type Jacobian<const N: usize> = SMatrix<DoubleDouble, 6, N>;

impl<const N: usize> Exact<'_, N> {
    /// J(q) of the tip.
    pub fn jacobian(&self, q: &Joints<N>) -> Jacobian<N> {
        let links = self.at_rest(q);
        let tip = links[N - 1].frame.placed(&self.0.tool.frame);
        jacobian(&links, tip.position)
    }

    /// J(q) of the origin of every link frame.
    pub fn link_jacobians(&self, q: &Joints<N>) -> [Jacobian<N>; N] {
        let links = self.at_rest(q);
        std::array::from_fn(|i| jacobian(&links[..=i], links[i].frame.position))
    }

    /// dJ/dt for joints that move at qd.
    pub fn jacobian_rate(&self, q: &Joints<N>, qd: &Joints<N>) -> Jacobian<N> {
        let [rate, _] = derivatives(|t| self.jacobian(&(q + qd * t)));
        rate
    }

    /// d/dt (J qd).
    pub fn tool_acceleration(
        &self,
        q: &Joints<N>,
        qd: &Joints<N>,
        qdd: &Joints<N>,
    ) -> Vector6<DoubleDouble> {
        let half = number(0.5);
        let velocity = |t| {
            let position = q + qd * t + qdd * (t * t * half);
            self.jacobian(&position) * (qd + qdd * t)
        };
        let [acceleration, _] = derivatives(velocity);
        acceleration
    }

    /// d tau/dq and d tau/dqd, dry friction constant.
    pub fn inverse_dynamics_derivatives(
        &self,
        q: &Joints<N>,
        qd: &Joints<N>,
        qdd: &Joints<N>,
    ) -> [SMatrix<DoubleDouble, N, N>; 2] {
        let along = |a: Joints<N>, b: Joints<N>| {
            let [derivative, _] = derivatives(|t| {
                let position = q + a * t;
                let torques = self.torques(&position, &(qd + b * t), qdd, &self.gravity());
                torques + self.springs(&position)
            });
            derivative
        };
        let none = Joints::<N>::zeros();
        let by_position: [_; N] = std::array::from_fn(|k| along(unit(k), none));
        let by_velocity: [_; N] = std::array::from_fn(|k| {
            along(none, unit(k)) + unit(k) * number(self.0.rows[k].viscous)
        });
        [by_position, by_velocity].map(|columns| SMatrix::from_columns(&columns))
    }

    /// d qdd/dq, d qdd/dqd and M^-1, dry friction constant.
    pub fn forward_dynamics_derivatives(
        &self,
        q: &Joints<N>,
        qd: &Joints<N>,
        tau: &Joints<N>,
    ) -> [SMatrix<DoubleDouble, N, N>; 3] {
        let m = self.mass_matrix(q);
        let qdd = self.forward_dynamics(q, qd, tau);
        let [by_position, by_velocity] = self.inverse_dynamics_derivatives(q, qd, &qdd);
        let units: [_; N] = std::array::from_fn(unit);
        let solved = |b: SMatrix<DoubleDouble, N, N>| {
            let columns: [_; N] = std::array::from_fn(|k| solve(m, b.column(k).into_owned()));
            SMatrix::from_columns(&columns)
        };
        [-by_position, -by_velocity, SMatrix::from_columns(&units)].map(solved)
    }

    /// J M^-1 J'.
    pub fn operational_inertia_inverse(&self, q: &Joints<N>) -> Matrix6<DoubleDouble> {
        let (m, j) = (self.mass_matrix(q), self.jacobian(q));
        let column = |k: usize| j * solve(m, j.row(k).transpose());
        Matrix6::from_columns(&[0, 1, 2, 3, 4, 5].map(column))
    }

    /// The masses of all bodies, and their centres.
    pub fn masses(&self, q: &Joints<N>) -> Vec<(DoubleDouble, Vector)> {
        let masses = self.0.rows.iter().map(|row| [row.mass, self.0.tool.mass]);
        let links = self.at_rest(q);
        let bodies = masses.zip(&links).flat_map(|(masses, link)| {
            let bodies = masses.into_iter().zip(&link.bodies);
            bodies.filter_map(|(mass, body)| Some((number(mass), body.as_ref()?.com)))
        });
        bodies.collect()
    }

    /// sum m c / sum m.
    pub fn center_of_mass(&self, q: &Joints<N>) -> Vector {
        let masses = self.masses(q);
        let total = masses.iter().fold(number(0.0), |sum, (m, _)| sum + *m);
        let moment = masses.iter().map(|(m, c)| c * *m);
        moment.fold(Vector::zeros(), |sum, h| sum + h) * (number(1.0) / total)
    }

    /// Its derivatives by the positions.
    pub fn center_of_mass_jacobian(&self, q: &Joints<N>) -> SMatrix<DoubleDouble, 3, N> {
        let columns: [_; N] = std::array::from_fn(|k| {
            let [derivative, _] = derivatives(|t| self.center_of_mass(&(q + unit(k) * t)));
            derivative
        });
        SMatrix::from_columns(&columns)
    }

    /// C(q, a) b = C(q, b) a, C of the Christoffel symbols: V is C(q, qd) qd, and this its bilinear form.
    pub fn coriolis(&self, q: &Joints<N>, a: &Joints<N>, b: &Joints<N>) -> Joints<N> {
        let difference = self.coriolis_vector(q, &(a + b)) - self.coriolis_vector(q, &(a - b));
        difference * number(0.25)
    }

    /// C' qd - G - K - F.
    pub fn momentum_bias(&self, q: &Joints<N>, qd: &Joints<N>) -> Joints<N> {
        let kinetic = SVector::from_fn(|j, _| qd.dot(&self.coriolis(q, qd, &unit(j))));
        kinetic - self.gravity_vector(q) - self.springs(q) - self.friction(qd)
    }

    /// M qdd_r + C(q, qd) qd_r + G + K + F(qd).
    pub fn passivity_torque(&self, q: &Joints<N>, [qd, qd_r, qdd_r]: [&Joints<N>; 3]) -> Joints<N> {
        let own = self.gravity_vector(q) + self.springs(q) + self.friction(qd);
        self.mass_matrix(q) * qdd_r + self.coriolis(q, qd, qd_r) + own
    }

    /// First and second derivative of tau along the motion that has these derivatives of q, Coulomb
    /// friction constant.
    pub fn inverse_dynamics_rates(&self, motion: &[Joints<N>; 5]) -> [Joints<N>; 2] {
        let torque = |t| {
            let [q, qd, qdd] = [0, 1, 2].map(|order| taylor(&motion[order..], t));
            self.torques(&q, &qd, &qdd, &self.gravity()) + self.springs(&q)
        };
        let [first, second] = derivatives(torque);
        let viscous =
            |rate: &Joints<N>| SVector::from_fn(|i, _| number(self.0.rows[i].viscous) * rate[i]);
        [first + viscous(&motion[2]), second + viscous(&motion[3])]
    }

    /// d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq, indexed as those of the functions: second
    /// derivatives in the direction of two arguments at once, less those of each.
    pub fn second_derivatives(
        &self,
        q: &Joints<N>,
        qd: &Joints<N>,
        qdd: &Joints<N>,
    ) -> SecondDerivatives<DoubleDouble, N> {
        // By positions along a and velocities along b.
        let along = |a: Joints<N>, b: Joints<N>| {
            let torque = |t| self.inverse_dynamics(&(q + a * t), &(qd + b * t), qdd);
            let [_, second] = derivatives(torque);
            second
        };
        let (none, half) = (Joints::<N>::zeros(), number(0.5));
        let by_q: [_; N] = std::array::from_fn(|k| along(unit(k), none));
        let by_qd: [_; N] = std::array::from_fn(|k| along(none, unit(k)));
        let mut all = [(); 4].map(|()| [SMatrix::<DoubleDouble, N, N>::zeros(); N]);
        for (j, k) in (0..N).flat_map(|j| (0..N).map(move |k| (j, k))) {
            let pairs = [
                along(unit(j) + unit(k), none) - by_q[j] - by_q[k],
                along(none, unit(j) + unit(k)) - by_qd[j] - by_qd[k],
                along(unit(j), unit(k)) - by_q[j] - by_qd[k],
            ];
            for i in 0..N {
                for (matrices, mixed) in all.iter_mut().zip(&pairs) {
                    matrices[i][(j, k)] = mixed[i] * half;
                }
            }
        }
        for k in 0..N {
            let [slope, _] = derivatives(|t| self.mass_matrix(&(q + unit(k) * t)));
            for i in 0..N {
                all[3][i].set_column(k, &slope.row(i).transpose());
            }
        }
        all.into()
    }

    fn at_rest(&self, q: &Joints<N>) -> [Link; N] {
        let rest = Joints::zeros();
        self.links(q, &rest, &rest, &Vector::zeros())
    }
}

/// Columns (z x (p - o), z) of revolute joints, (z, 0) of prismatic ones, and zero for those beyond.
fn jacobian<const N: usize>(links: &[Link], p: Vector) -> Jacobian<N> {
    let mut columns = Jacobian::<N>::zeros();
    for (k, link) in links.iter().enumerate() {
        let (linear, angular) = match link.joint_type {
            JointType::Revolute => (link.axis.cross(&(p - link.origin)), link.axis),
            JointType::Prismatic => (link.axis, Vector::zeros()),
        };
        columns.fixed_view_mut::<3, 1>(0, k).copy_from(&linear);
        columns.fixed_view_mut::<3, 1>(3, k).copy_from(&angular);
    }
    columns
}

/// One joint alone moves.
fn unit<const N: usize>(k: usize) -> Joints<N> {
    SVector::from_fn(|i, _| number(if i == k { 1.0 } else { 0.0 }))
}

/// x + x' t + x'' t^2/2 + ...
fn taylor<const N: usize>(derivatives: &[Joints<N>], t: DoubleDouble) -> Joints<N> {
    let mut factor = number(1.0);
    let mut sum = Joints::zeros();
    for (order, derivative) in derivatives.iter().enumerate() {
        sum += derivative * factor;
        factor = factor * t / number((order + 1) as f64);
    }
    sum
}

/// 2^-15: of a motion of some radians per second six powers of it leave less than 1e-20, and of 31
/// digits 22 are left by its square.
const STEP: f64 = 1.0 / 32768.0;

/// First and second derivative at 0, by central differences of order six (Fornberg 1988).
fn derivatives<const R: usize, const C: usize>(
    f: impl Fn(DoubleDouble) -> SMatrix<DoubleDouble, R, C>,
) -> [SMatrix<DoubleDouble, R, C>; 2] {
    let h = number(STEP);
    let pairs = [1.0, 2.0, 3.0].map(|k| [f(h * number(k)), f(-h * number(k))]);
    let odd = pairs.map(|[after, before]| after - before);
    let even = pairs.map(|[after, before]| after + before);
    let first = odd[0] * number(45.0) - odd[1] * number(9.0) + odd[2];
    let second = even[0] * number(270.0) - even[1] * number(27.0) + even[2] * number(2.0);
    let second = second - f(number(0.0)) * number(490.0);
    let one = number(1.0);
    [
        first * (one / (h * number(60.0))),
        second * (one / (h * h * number(180.0))),
    ]
}
