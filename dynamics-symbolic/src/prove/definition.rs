//! The textbook definition, evaluated in the prime field from the raw table.
//!
//!   A_i = Rz(theta) Tz(d) Tx(a) Rx(alpha)   or   Rx(alpha) Tx(a) Rz(theta) Tz(d)
//!   T = sum 1/2 (m c'.c' + w.I w) + sum 1/2 r^2 J_m qd^2,   U = -sum m g.c
//!   M_ij = d2T / dqd_i dqd_j
//!   V_i = sum_jk c_ijk qd_j qd_k,  c_ijk = 1/2 (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i)
//!   G_i = dU/dq_i
//!
//! Velocities are derivatives of positions by dual numbers. T is quadratic in
//! qd, so that its second derivatives are differences, without a limit.

use super::assignment::{Assignment, Number};
use super::dual::Dual;
use crate::exact::Rational;
use crate::function::Function;
use crate::linear::{Matrix3, Ring, Symmetric3, Vector3};
use crate::robot::{Convention, Interpretation, JointType, Robot};

type Vector = Vec<Number>;
type Matrix = Vec<Vector>;

/// A row of the table in the field.
struct Row {
    joint_type: JointType,
    twist: (Number, Number),
    turn: (Number, Number),
    a: Number,
    d: Number,
    mass: Number,
    com: Vector3<Number>,
    inertia: Symmetric3<Number>,
    reflected: Number,
    viscous: Number,
    coulomb: Number,
}

/// A robot at a random point of the field.
pub struct Definition {
    convention: Convention,
    gravity: Vector3<Number>,
    rows: Vec<Row>,
    half: Number,
    q: Vec<Position<Number>>,
    qd: Vector,
    qdd: Vector,
    tau: Vector,
    signs: Vector,
    unfaithful: bool,
}

/// The position of a joint: sine and cosine of an angle, or a displacement.
#[derive(Clone, Copy)]
struct Position<R> {
    s: R,
    c: R,
    q: R,
}

impl<R: Ring> Position<R> {
    /// The position with its derivative where q changes at the rate `rate`.
    fn moving(self, rate: R) -> Position<Dual<R>> {
        Position {
            s: Dual::new(self.s, self.c * rate),
            c: Dual::new(self.c, -(self.s * rate)),
            q: Dual::new(self.q, rate),
        }
    }
}

/// A homogeneous transform.
#[derive(Clone, Copy)]
struct Pose<R> {
    rotation: Matrix3<R>,
    origin: Vector3<R>,
}

impl<R: Ring> Pose<R> {
    fn then(&self, next: &Pose<R>) -> Pose<R> {
        Pose {
            rotation: self.rotation.product(&next.rotation),
            origin: self.rotation.apply(next.origin) + self.origin,
        }
    }
}

/// The ring of the table's numbers inside another ring.
trait Lift: Ring {
    fn lift(x: Number) -> Self;
}

impl Lift for Number {
    fn lift(x: Number) -> Self {
        x
    }
}

impl<R: Lift> Lift for Dual<R> {
    fn lift(x: Number) -> Self {
        Dual::new(R::lift(x), R::lift(Number::ZERO))
    }
}

impl Definition {
    /// Reads the raw table.
    pub fn new(point: &mut Assignment, robot: &Robot) -> Self {
        let rows = robot.rows.iter().map(|row| {
            let ratio = point.value(&row.gear_ratio);
            let [xx, yy, zz, xy, yz, xz] = [0, 1, 2, 3, 4, 5].map(|k| point.value(&row.inertia[k]));
            Row {
                joint_type: row.joint_type,
                twist: point.sin_cos(&row.alpha),
                turn: point.sin_cos(&row.theta),
                a: point.value(&row.a),
                d: point.value(&row.d),
                mass: point.value(&row.mass),
                com: Vector3([0, 1, 2].map(|k| point.value(&row.com[k]))),
                inertia: Symmetric3 {
                    xx,
                    yy,
                    zz,
                    xy,
                    yz,
                    xz,
                },
                reflected: ratio * ratio * point.value(&row.motor_inertia),
                viscous: point.value(&row.viscous),
                coulomb: point.value(&row.coulomb),
            }
        });
        let rows = rows.collect();
        let gravity = Vector3([0, 1, 2].map(|k| point.value(&robot.gravity[k])));
        let half = Interpretation::rational(point, &(Rational::ONE / Rational::from(2)));
        let joints = point.joints();
        Definition {
            convention: robot.convention,
            gravity,
            rows,
            half,
            q: joints
                .iter()
                .map(|j| Position {
                    s: j.sin_cos.0,
                    c: j.sin_cos.1,
                    q: j.q,
                })
                .collect(),
            qd: joints.iter().map(|j| j.qd).collect(),
            qdd: joints.iter().map(|j| j.qdd).collect(),
            tau: joints.iter().map(|j| j.tau).collect(),
            signs: joints.iter().map(|j| j.sign).collect(),
            unfaithful: point.is_unfaithful(),
        }
    }

    /// What the outputs of a function must be. Forward dynamics is judged by
    /// the equation that its result must satisfy: where M qdd + V + G + F = tau
    /// holds for the `computed` accelerations, they are what is expected.
    pub fn expected(&self, function: Function, computed: &[Option<Number>]) -> Vector {
        if self.unfaithful {
            return Vec::new();
        }
        match function {
            Function::MassMatrix => self.mass_matrix(&self.q).concat(),
            Function::CoriolisVector => self.coriolis_vector(),
            Function::GravityVector => self.gravity_vector(),
            Function::FrictionVector => self.friction_vector(),
            Function::InverseDynamics => self.inverse_dynamics(&self.qdd),
            Function::ForwardDynamics => self.forward_dynamics(computed),
            Function::KineticEnergy => vec![self.kinetic_energy(&self.q, &self.qd)],
            Function::PotentialEnergy => vec![self.potential_energy(&self.q)],
            Function::BiasForce => self.bias_force(),
            Function::CoriolisMatrix => self.coriolis_matrix().concat(),
            Function::CoriolisCoefficients => self.coriolis_coefficients(),
            Function::CentrifugalCoefficients => self.centrifugal_coefficients(),
            Function::ForwardKinematics => self
                .poses(&self.q)
                .last()
                .map(homogeneous)
                .into_iter()
                .flatten()
                .collect(),
            Function::LinkPoses => self.poses(&self.q).iter().flat_map(homogeneous).collect(),
            Function::Jacobian => self.jacobian().concat(),
        }
    }

    fn dof(&self) -> usize {
        self.rows.len()
    }

    /// A_i of the table.
    fn transform<R: Lift>(&self, row: &Row, position: &Position<R>) -> Pose<R> {
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        let lift = R::lift;
        let ((st, ct), d) = match row.joint_type {
            // sin(theta + q), cos(theta + q)
            JointType::Revolute => {
                let (s, c) = (lift(row.turn.0), lift(row.turn.1));
                let turn = (
                    s * position.c + c * position.s,
                    c * position.c - s * position.s,
                );
                (turn, lift(row.d))
            }
            JointType::Prismatic => (
                (lift(row.turn.0), lift(row.turn.1)),
                lift(row.d) + position.q,
            ),
        };
        let (sa, ca) = (lift(row.twist.0), lift(row.twist.1));
        let screw_z = Pose {
            rotation: Matrix3([[ct, -st, zero], [st, ct, zero], [zero, zero, one]]),
            origin: Vector3::new(zero, zero, d),
        };
        let screw_x = Pose {
            rotation: Matrix3([[one, zero, zero], [zero, ca, -sa], [zero, sa, ca]]),
            origin: Vector3::new(lift(row.a), zero, zero),
        };
        match self.convention {
            Convention::Standard => screw_z.then(&screw_x),
            Convention::Modified => screw_x.then(&screw_z),
        }
    }

    /// The poses of all link frames in the base.
    fn poses<R: Lift>(&self, q: &[Position<R>]) -> Vec<Pose<R>> {
        let mut poses: Vec<Pose<R>> = Vec::with_capacity(q.len());
        for (row, position) in self.rows.iter().zip(q) {
            let transform = self.transform(row, position);
            poses.push(match poses.last() {
                Some(previous) => previous.then(&transform),
                None => transform,
            });
        }
        poses
    }

    /// T = sum 1/2 (m c'.c' + w.I w) + sum 1/2 r^2 J_m qd^2, where c' is the
    /// derivative of c and w in the link frame that of the rotation: [w]x = R^T R'.
    fn kinetic_energy<R: Lift>(&self, q: &[Position<R>], qd: &[R]) -> R {
        let zero = R::lift(Number::ZERO);
        let moving: Vec<_> = q.iter().zip(qd).map(|(q, &qd)| q.moving(qd)).collect();
        let mut twice = zero;
        for (i, pose) in self.poses(&moving).iter().enumerate() {
            let row = &self.rows[i];
            let com = Vector3(row.com.0.map(Dual::<R>::lift));
            let center = pose.rotation.apply(com) + pose.origin;
            let velocity = Vector3(center.0.map(|x| x.derivative));
            let w = angular_velocity(&pose.rotation);
            let inertia = Symmetric3 {
                xx: R::lift(row.inertia.xx),
                yy: R::lift(row.inertia.yy),
                zz: R::lift(row.inertia.zz),
                xy: R::lift(row.inertia.xy),
                yz: R::lift(row.inertia.yz),
                xz: R::lift(row.inertia.xz),
            };
            twice = twice
                + R::lift(row.mass) * velocity.dot(velocity)
                + w.dot(inertia.apply(w))
                + R::lift(row.reflected) * qd[i] * qd[i];
        }
        R::lift(self.half) * twice
    }

    /// U = -sum m g.c
    fn potential_energy<R: Lift>(&self, q: &[Position<R>]) -> R {
        let gravity = Vector3(self.gravity.0.map(R::lift));
        let mut energy = R::lift(Number::ZERO);
        for (row, pose) in self.rows.iter().zip(self.poses(q)) {
            let center = pose.rotation.apply(Vector3(row.com.0.map(R::lift))) + pose.origin;
            energy = energy - R::lift(row.mass) * gravity.dot(center);
        }
        energy
    }

    /// d2T/dqd_i dqd_j = T(e_i + e_j) - T(e_i) - T(e_j), for T is quadratic in qd.
    fn mass_matrix<R: Lift>(&self, q: &[Position<R>]) -> Vec<Vec<R>> {
        let n = self.dof();
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        let unit = |axes: &[usize]| {
            let mut qd = vec![zero; n];
            for &axis in axes {
                qd[axis] = qd[axis] + one;
            }
            self.kinetic_energy(q, &qd)
        };
        let single: Vec<_> = (0..n).map(|i| unit(&[i])).collect();
        let mut matrix = vec![vec![zero; n]; n];
        for i in 0..n {
            matrix[i][i] = single[i] + single[i];
            for j in 0..i {
                matrix[i][j] = unit(&[i, j]) - single[i] - single[j];
                matrix[j][i] = matrix[i][j];
            }
        }
        matrix
    }

    /// The positions with their derivatives in the direction of joint k.
    fn along(&self, k: usize) -> Vec<Position<Dual<Number>>> {
        let rate = |i: usize| if i == k { Number::ONE } else { Number::ZERO };
        self.q
            .iter()
            .enumerate()
            .map(|(i, q)| q.moving(rate(i)))
            .collect()
    }

    /// c_ijk, Christoffel symbols of the first kind, indexed [i][j][k].
    fn christoffel(&self) -> Vec<Matrix> {
        let n = self.dof();
        let slopes: Vec<Matrix> = (0..n)
            .map(|k| {
                let matrix = self.mass_matrix(&self.along(k));
                matrix
                    .into_iter()
                    .map(|row| row.into_iter().map(|x| x.derivative).collect())
                    .collect()
            })
            .collect();
        let symbol = |i: usize, j: usize, k: usize| {
            self.half * (slopes[k][i][j] + slopes[j][i][k] - slopes[i][j][k])
        };
        let matrix = |i| {
            (0..n)
                .map(|j| (0..n).map(|k| symbol(i, j, k)).collect())
                .collect()
        };
        (0..n).map(matrix).collect()
    }

    /// V = d/dt (dT/dqd) - dT/dq at qdd = 0, which is sum c_ijk qd_j qd_k.
    fn coriolis_vector(&self) -> Vector {
        let n = self.dof();
        let moving: Vec<_> = self
            .q
            .iter()
            .zip(&self.qd)
            .map(|(q, &qd)| q.moving(qd))
            .collect();
        let constant =
            |x: &[Number]| -> Vec<Dual<Number>> { x.iter().map(|&x| Dual::lift(x)).collect() };
        let energy = |qd: &[Number]| self.kinetic_energy(&moving, &constant(qd)).derivative;
        let still = energy(&self.qd);
        let mut unit = vec![Number::ZERO; n];
        (0..n)
            .map(|i| {
                // dT/dqd_i = T(qd + e_i) - T(qd) - T(e_i); its rate along the motion.
                let mut shifted = self.qd.clone();
                shifted[i] = shifted[i] + Number::ONE;
                unit[i] = Number::ONE;
                let momentum_rate = energy(&shifted) - still - energy(&unit);
                unit[i] = Number::ZERO;
                let slope = self
                    .kinetic_energy(&self.along(i), &constant(&self.qd))
                    .derivative;
                momentum_rate - slope
            })
            .collect()
    }

    fn gravity_vector(&self) -> Vector {
        (0..self.dof())
            .map(|i| self.potential_energy(&self.along(i)).derivative)
            .collect()
    }

    fn friction_vector(&self) -> Vector {
        let force =
            |((row, &qd), &sign): ((&Row, &Number), &Number)| row.viscous * qd + row.coulomb * sign;
        self.rows
            .iter()
            .zip(&self.qd)
            .zip(&self.signs)
            .map(force)
            .collect()
    }

    fn bias_force(&self) -> Vector {
        sum(
            &sum(&self.coriolis_vector(), &self.gravity_vector()),
            &self.friction_vector(),
        )
    }

    fn inverse_dynamics(&self, qdd: &[Number]) -> Vector {
        let inertial: Vector = self
            .mass_matrix(&self.q)
            .iter()
            .map(|row| {
                row.iter()
                    .zip(qdd)
                    .fold(Number::ZERO, |sum, (&m, &x)| sum + m * x)
            })
            .collect();
        sum(&inertial, &self.bias_force())
    }

    /// The accelerations are right if they satisfy the equations of motion. Where
    /// M is identically singular there are none, and the pivots up to the first
    /// zero are all that the generated function reads.
    fn forward_dynamics(&self, computed: &[Option<Number>]) -> Vector {
        let n = self.dof();
        let matrix = self.mass_matrix(&self.q);
        let pivots = pivots(matrix.clone());
        let computed: Vector = computed.iter().map(|x| x.unwrap_or(Number::ZERO)).collect();
        if computed.len() != 3 * n {
            return Vec::new();
        }
        let singular = pivots.contains(&Some(Number::ZERO));
        let satisfied = singular || self.inverse_dynamics(&computed[..n]) == self.tau;
        let accelerations = computed[..n]
            .iter()
            .map(|&x| if satisfied { x } else { x + Number::ONE });
        let pivots = pivots
            .iter()
            .zip(&computed[n..])
            .map(|(pivot, &computed)| pivot.unwrap_or(computed));
        let diagonal = (0..n).map(|i| matrix[i][i]);
        accelerations.chain(pivots).chain(diagonal).collect()
    }

    fn coriolis_matrix(&self) -> Matrix {
        let contract = |row: &Vector| {
            row.iter()
                .zip(&self.qd)
                .fold(Number::ZERO, |sum, (&c, &qd)| sum + c * qd)
        };
        self.christoffel()
            .iter()
            .map(|matrix| matrix.iter().map(contract).collect())
            .collect()
    }

    /// By rows; columns (1,2), (1,3), ..., (n-1,n).
    fn coriolis_coefficients(&self) -> Vector {
        let n = self.dof();
        let pairs: Vec<_> = (0..n)
            .flat_map(|j| (j + 1..n).map(move |k| (j, k)))
            .collect();
        let row = |matrix: &Matrix| -> Vector {
            pairs
                .iter()
                .map(|&(j, k)| matrix[j][k] + matrix[k][j])
                .collect()
        };
        self.christoffel().iter().flat_map(row).collect()
    }

    /// By rows; column j is the coefficient of qd_j^2.
    fn centrifugal_coefficients(&self) -> Vector {
        let diagonal =
            |matrix: &Matrix| -> Vector { (0..self.dof()).map(|j| matrix[j][j]).collect() };
        self.christoffel().iter().flat_map(diagonal).collect()
    }

    /// By rows: vx vy vz wx wy wz of the last frame's origin for unit velocity of each joint.
    fn jacobian(&self) -> Matrix {
        let n = self.dof();
        let mut rows = vec![vec![Number::ZERO; n]; 6];
        for j in 0..n {
            let poses = self.poses(&self.along(j));
            let Some(tip) = poses.last() else { continue };
            let body = angular_velocity(&tip.rotation);
            let rotation = Matrix3(tip.rotation.0.map(|row| row.map(|x| x.value)));
            let w = rotation.apply(body);
            for k in 0..3 {
                rows[k][j] = tip.origin[k].derivative;
                rows[3 + k][j] = w[k];
            }
        }
        rows
    }
}

/// w of [w]x = R^T R', in the axes of the turned frame.
fn angular_velocity<R: Ring>(rotation: &Matrix3<Dual<R>>) -> Vector3<R> {
    let value = Matrix3(rotation.0.map(|row| row.map(|x| x.value)));
    let rate = Matrix3(rotation.0.map(|row| row.map(|x| x.derivative)));
    let entry = |i: usize, j: usize| value.column(i).dot(rate.column(j));
    Vector3::new(entry(2, 1), entry(0, 2), entry(1, 0))
}

/// The 4 x 4 matrix of a pose, by rows.
fn homogeneous(pose: &Pose<Number>) -> Vector {
    let mut entries = Vec::with_capacity(16);
    for (row, &x) in pose.rotation.0.iter().zip(&pose.origin.0) {
        entries.extend_from_slice(row);
        entries.push(x);
    }
    entries.extend([Number::ZERO, Number::ZERO, Number::ZERO, Number::ONE]);
    entries
}

fn sum(a: &[Number], b: &[Number]) -> Vector {
    a.iter().zip(b).map(|(&a, &b)| a + b).collect()
}

/// The pivots of M = U D U^T, eliminated from the last row upwards; none after one that is zero.
fn pivots(mut matrix: Matrix) -> Vec<Option<Number>> {
    let n = matrix.len();
    let mut pivots = vec![None; n];
    for j in (0..n).rev() {
        pivots[j] = Some(matrix[j][j]);
        let Some(inverse) = matrix[j][j].inverse() else {
            break;
        };
        for i in 0..j {
            let factor = matrix[i][j] * inverse;
            for k in 0..j {
                matrix[i][k] = matrix[i][k] - factor * matrix[j][k];
            }
        }
    }
    pivots
}
