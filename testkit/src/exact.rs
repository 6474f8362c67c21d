//! The dynamics of a table in numbers of 31 digits: the measure of errors.
//!
//! Newton-Euler in the axes of the world, as short as it can be written: every link's motion, and
//! for every joint the sum of the moments of all forces beyond it. It shares nothing with the
//! derivation, and no formula with the runtime's numeric algorithms.

mod controllers;

use std::f64::consts::FRAC_PI_2;

use robot_dynamics::nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use robot_dynamics::{
    DoubleDouble, Scalar,
    table::{Convention, JointType, Row, Table},
};

type Vector = Vector3<DoubleDouble>;
type Matrix = Matrix3<DoubleDouble>;

/// The dynamics of a table at the doubles that stand in it; multiples of pi/2 are meant exactly.
pub struct Exact<'a, const N: usize>(pub &'a Table<N>);

/// A joint, and the bodies that it moves and the joints behind it do not.
struct Link {
    joint_type: JointType,
    axis: Vector,
    /// A point of the joint's axis.
    origin: Vector,
    /// The link frame of the table.
    frame: Frame,
    /// The link itself, and the tool.
    bodies: [Option<Body>; 2],
}

/// The force and the moment that the motion of a body takes.
struct Body {
    com: Vector,
    force: Vector,
    /// About the centre of mass.
    moment: Vector,
}

/// A frame in the world.
#[derive(Clone, Copy)]
struct Frame {
    rotation: Matrix,
    position: Vector,
}

/// The motion of a body: of one of its points, and its rotation.
#[derive(Clone, Copy)]
struct Motion {
    point: Vector,
    acceleration: Vector,
    angular_velocity: Vector,
    angular_acceleration: Vector,
}

impl<const N: usize> Exact<'_, N> {
    /// M(q), reflected inertias included.
    pub fn mass_matrix(&self, q: &SVector<DoubleDouble, N>) -> SMatrix<DoubleDouble, N, N> {
        let still = SVector::zeros();
        let columns: [_; N] = std::array::from_fn(|k| {
            let mut unit = still;
            unit[k] = number(1.0);
            self.torques(q, &still, &unit, &Vector::zeros())
        });
        SMatrix::from_columns(&columns)
    }

    /// V(q, qd).
    pub fn coriolis_vector(
        &self,
        q: &SVector<DoubleDouble, N>,
        qd: &SVector<DoubleDouble, N>,
    ) -> SVector<DoubleDouble, N> {
        self.torques(q, qd, &SVector::zeros(), &Vector::zeros())
    }

    /// G(q).
    pub fn gravity_vector(&self, q: &SVector<DoubleDouble, N>) -> SVector<DoubleDouble, N> {
        self.torques(q, &SVector::zeros(), &SVector::zeros(), &self.gravity())
    }

    /// M qdd + V + G + K + F.
    pub fn inverse_dynamics(
        &self,
        q: &SVector<DoubleDouble, N>,
        qd: &SVector<DoubleDouble, N>,
        qdd: &SVector<DoubleDouble, N>,
    ) -> SVector<DoubleDouble, N> {
        self.torques(q, qd, qdd, &self.gravity()) + self.springs(q) + self.friction(qd)
    }

    /// qdd of `M qdd + V + G + K + F = tau`.
    pub fn forward_dynamics(
        &self,
        q: &SVector<DoubleDouble, N>,
        qd: &SVector<DoubleDouble, N>,
        tau: &SVector<DoubleDouble, N>,
    ) -> SVector<DoubleDouble, N> {
        let bias = self.inverse_dynamics(q, qd, &SVector::zeros());
        solve(self.mass_matrix(q), tau - bias)
    }

    fn gravity(&self) -> Vector {
        Vector::from(self.0.gravity.map(number))
    }

    /// K(q).
    pub fn springs(&self, q: &SVector<DoubleDouble, N>) -> SVector<DoubleDouble, N> {
        SVector::from_fn(|i, _| {
            let spring = self.0.rows[i].spring;
            number(spring.stiffness) * (q[i] - number(spring.rest))
        })
    }

    fn friction(&self, qd: &SVector<DoubleDouble, N>) -> SVector<DoubleDouble, N> {
        SVector::from_fn(|i, _| {
            let row = &self.0.rows[i];
            let sign = qd[i].sign();
            let coulomb = number(row.coulomb[usize::from(sign.high() < 0.0)]);
            let beyond = row.stribeck.map(|stribeck| {
                let x = qd[i] / number(stribeck.velocity);
                (number(stribeck.friction) - coulomb) * (-(x * x)).exp()
            });
            let dry = coulomb + beyond.unwrap_or_default();
            number(row.viscous) * qd[i] + dry * sign
        })
    }

    fn torques(
        &self,
        q: &SVector<DoubleDouble, N>,
        qd: &SVector<DoubleDouble, N>,
        qdd: &SVector<DoubleDouble, N>,
        gravity: &Vector,
    ) -> SVector<DoubleDouble, N> {
        let links = self.links(q, qd, qdd, gravity);
        SVector::from_fn(|i, _| {
            let joint = &links[i];
            let row = &self.0.rows[i];
            let gear_ratio = number(row.gear_ratio);
            let reflected = gear_ratio * gear_ratio * number(row.motor_inertia);
            let bodies = links[i..]
                .iter()
                .flat_map(|link| link.bodies.iter().flatten());
            bodies.fold(reflected * qdd[i], |sum, body| {
                let moment = body.moment + (body.com - joint.origin).cross(&body.force);
                sum + match joint.joint_type {
                    JointType::Revolute => joint.axis.dot(&moment),
                    JointType::Prismatic => joint.axis.dot(&body.force),
                }
            })
        })
    }

    fn links(
        &self,
        q: &SVector<DoubleDouble, N>,
        qd: &SVector<DoubleDouble, N>,
        qdd: &SVector<DoubleDouble, N>,
        gravity: &Vector,
    ) -> [Link; N] {
        let world = Frame {
            rotation: Matrix::identity(),
            position: Vector::zeros(),
        };
        let mut frame = world.placed(&self.0.base);
        let mut motion = Motion {
            point: Vector::zeros(),
            acceleration: -gravity,
            angular_velocity: Vector::zeros(),
            angular_acceleration: Vector::zeros(),
        };
        std::array::from_fn(|i| {
            let row = &self.0.rows[i];
            if self.0.convention == Convention::Modified {
                frame = frame.along_x(row);
            }
            let (axis, origin) = (frame.rotation.column(2).into_owned(), frame.position);
            frame = frame.through_joint(row, q[i]);
            motion = match row.joint_type {
                JointType::Revolute => motion.at(origin).turned(&axis, qd[i], qdd[i]),
                JointType::Prismatic => motion.at(frame.position).moved(&axis, qd[i], qdd[i]),
            };
            if self.0.convention == Convention::Standard {
                frame = frame.along_x(row);
            }
            let link = motion.of_body((row.mass, row.com, row.inertia), &frame);
            let tool = &self.0.tool;
            let tool = (i + 1 == N).then(|| {
                let frame = frame.placed(&tool.frame);
                motion.of_body((tool.mass, tool.com, tool.inertia), &frame)
            });
            Link {
                joint_type: row.joint_type,
                axis,
                origin,
                frame,
                bodies: [Some(link), tool],
            }
        })
    }
}

impl Frame {
    /// `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`.
    fn placed(&self, place: &robot_dynamics::table::Frame) -> Frame {
        let [zero, one] = [0.0, 1.0].map(number);
        let [roll, pitch, yaw] = place.rpy.map(of_constant);
        let (s, c) = yaw;
        let about_z = Matrix::new(c, -s, zero, s, c, zero, zero, zero, one);
        let (s, c) = pitch;
        let about_y = Matrix::new(c, zero, s, zero, one, zero, -s, zero, c);
        Frame {
            rotation: self.rotation * about_z * about_y * about_x(roll),
            position: self.position + self.rotation * Vector::from(place.xyz.map(number)),
        }
    }

    /// `Rx(alpha) Tx(a)`.
    fn along_x(&self, row: &Row) -> Frame {
        Frame {
            rotation: self.rotation * about_x(of_constant(row.alpha)),
            position: self.position + self.rotation.column(0) * number(row.a),
        }
    }

    /// `Rz(theta) Tz(d)` with the joint's position added.
    fn through_joint(&self, row: &Row, q: DoubleDouble) -> Frame {
        let [zero, one] = [0.0, 1.0].map(number);
        let ((s, c), d) = match row.joint_type {
            JointType::Revolute => (sum(q.sin_cos(), of_constant(row.theta)), number(row.d)),
            JointType::Prismatic => (of_constant(row.theta), number(row.d) + q),
        };
        let turn = Matrix::new(c, -s, zero, s, c, zero, zero, zero, one);
        Frame {
            rotation: self.rotation * turn,
            position: self.position + self.rotation.column(2) * d,
        }
    }
}

impl Motion {
    /// The same motion, told by another point of the body.
    fn at(&self, point: Vector) -> Motion {
        let (w, r) = (&self.angular_velocity, point - self.point);
        let acceleration =
            self.acceleration + self.angular_acceleration.cross(&r) + w.cross(&w.cross(&r));
        Motion {
            point,
            acceleration,
            ..*self
        }
    }

    /// The motion of the next link, which turns about an axis through the point.
    fn turned(&self, axis: &Vector, qd: DoubleDouble, qdd: DoubleDouble) -> Motion {
        let rate = axis * qd;
        Motion {
            angular_velocity: self.angular_velocity + rate,
            angular_acceleration: self.angular_acceleration
                + self.angular_velocity.cross(&rate)
                + axis * qdd,
            ..*self
        }
    }

    /// The motion of the next link, which slides along an axis.
    fn moved(&self, axis: &Vector, qd: DoubleDouble, qdd: DoubleDouble) -> Motion {
        let coriolis = self.angular_velocity.cross(&(axis * (qd + qd)));
        Motion {
            acceleration: self.acceleration + coriolis + axis * qdd,
            ..*self
        }
    }

    /// Newton and Euler for a body of that mass, centre of mass and inertia tensor in `frame`.
    fn of_body(&self, (mass, com, inertia): (f64, [f64; 3], [f64; 6]), frame: &Frame) -> Body {
        let [xx, yy, zz, xy, yz, xz] = inertia.map(number);
        let tensor = Matrix::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let tensor = frame.rotation * tensor * frame.rotation.transpose();
        let com = frame.position + frame.rotation * Vector::from(com.map(number));
        let w = &self.angular_velocity;
        Body {
            com,
            force: self.at(com).acceleration * number(mass),
            moment: tensor * self.angular_acceleration + w.cross(&(tensor * w)),
        }
    }
}

fn about_x((s, c): (DoubleDouble, DoubleDouble)) -> Matrix {
    let [zero, one] = [0.0, 1.0].map(number);
    Matrix::new(one, zero, zero, zero, c, -s, zero, s, c)
}

fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from(x)
}

/// Sine and cosine of the sum of two angles.
fn sum(
    (s, c): (DoubleDouble, DoubleDouble),
    (t, d): (DoubleDouble, DoubleDouble),
) -> (DoubleDouble, DoubleDouble) {
    (s * d + c * t, c * d - s * t)
}

/// Sine and cosine of an angle of the table, exact at multiples of pi/2.
fn of_constant(angle: f64) -> (DoubleDouble, DoubleDouble) {
    let quarters = (angle / FRAC_PI_2).round();
    if quarters * FRAC_PI_2 != angle {
        return number(angle).sin_cos();
    }
    let [zero, one] = [0.0, 1.0].map(number);
    match quarters.rem_euclid(4.0) {
        0.0 => (zero, one),
        1.0 => (one, zero),
        2.0 => (zero, -one),
        _ => (-one, zero),
    }
}

/// The solution of m x = b by elimination; M needs no exchange of rows.
fn solve<const N: usize>(
    mut m: SMatrix<DoubleDouble, N, N>,
    mut b: SVector<DoubleDouble, N>,
) -> SVector<DoubleDouble, N> {
    for k in 0..N {
        for i in k + 1..N {
            let factor = m[(i, k)] / m[(k, k)];
            for j in k + 1..N {
                m[(i, j)] = m[(i, j)] - factor * m[(k, j)];
            }
            b[i] = b[i] - factor * b[k];
        }
    }
    for k in (0..N).rev() {
        let known = (k + 1..N).fold(b[k], |rest, j| rest - m[(k, j)] * b[j]);
        b[k] = known / m[(k, k)];
    }
    b
}
