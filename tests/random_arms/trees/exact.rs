//! The dynamics of a tree in numbers of 31 digits, from the cells of its table.
//!
//! Newton-Euler in the axes of the world, or of a base that moves: the motion of every body, and for every joint the moments
//! of all forces on bodies that it carries. It shares nothing with the derivation, and no formula with the runtime's numeric
//! algorithms.

use std::f64::consts::FRAC_PI_2;

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Body, Convention, JointType, Placement, Robot, Row, Value};
use robot_dynamics::nalgebra::{Matrix3, Vector3};
use robot_dynamics::{DoubleDouble, Scalar};

pub(super) type Vector = Vector3<DoubleDouble>;
type Matrix = Matrix3<DoubleDouble>;

pub(super) fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from(x)
}

/// A cell without fields.
fn cell(value: &Value) -> DoubleDouble {
    match value {
        Value::Rational(x) => {
            let high = x.to_f64().value();
            let rest = x.clone() - Rational::try_from(high).expect("a finite number");
            number(high) + number(rest.to_f64().value())
        }
        // The double nearest to pi, and the double nearest to the rest.
        Value::Pi => number(std::f64::consts::PI) + number(1.224_646_799_147_353_2e-16),
        Value::Field(_) => panic!("a tree of numbers"),
        Value::Neg(a) => -cell(a),
        Value::Add(a, b) => cell(a) + cell(b),
        Value::Mul(a, b) => cell(a) * cell(b),
        Value::Div(a, b) => cell(a) / cell(b),
    }
}

/// Sine and cosine of an angle of the table, whose quarter turns are exact.
fn turn(angle: &Value) -> (DoubleDouble, DoubleDouble) {
    let quarters = (angle.to_f64(&[]) / FRAC_PI_2).round();
    if (angle.to_f64(&[]) - quarters * FRAC_PI_2).abs() > 1e-9 {
        return cell(angle).sin_cos();
    }
    let [zero, one] = [0.0, 1.0].map(number);
    match quarters.rem_euclid(4.0) {
        0.0 => (zero, one),
        1.0 => (one, zero),
        2.0 => (zero, -one),
        _ => (-one, zero),
    }
}

/// Sine and cosine of the sum of two angles.
fn sum(
    (s, c): (DoubleDouble, DoubleDouble),
    (t, d): (DoubleDouble, DoubleDouble),
) -> (DoubleDouble, DoubleDouble) {
    (s * d + c * t, c * d - s * t)
}

/// A frame in the world.
#[derive(Clone, Copy)]
pub(super) struct Pose {
    pub(super) rotation: Matrix,
    pub(super) position: Vector,
}

impl Pose {
    fn then(&self, rotation: Matrix, position: Vector) -> Pose {
        Pose {
            rotation: self.rotation * rotation,
            position: self.position + self.rotation * position,
        }
    }

    /// `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`, one after the other.
    fn placed(self, places: &[Placement]) -> Pose {
        places.iter().fold(self, |pose, Placement { xyz, rpy }| {
            let [roll, pitch, yaw] = rpy.each_ref().map(turn);
            pose.then(Matrix::identity(), Vector::from(xyz.each_ref().map(cell)))
                .then(
                    about_z(yaw) * about_y(pitch) * about_x(roll),
                    Vector::zeros(),
                )
        })
    }

    /// `Rx(alpha) Tx(a)`.
    fn along_x(self, row: &Row) -> Pose {
        let turned = self.then(about_x(turn(&row.alpha)), Vector::zeros());
        turned.then(Matrix::identity(), Vector::x() * cell(&row.a))
    }
}

fn about_x((s, c): (DoubleDouble, DoubleDouble)) -> Matrix {
    let [zero, one] = [0.0, 1.0].map(number);
    Matrix::new(one, zero, zero, zero, c, -s, zero, s, c)
}

fn about_y((s, c): (DoubleDouble, DoubleDouble)) -> Matrix {
    let [zero, one] = [0.0, 1.0].map(number);
    Matrix::new(c, zero, s, zero, one, zero, -s, zero, c)
}

fn about_z((s, c): (DoubleDouble, DoubleDouble)) -> Matrix {
    let [zero, one] = [0.0, 1.0].map(number);
    Matrix::new(c, -s, zero, s, c, zero, zero, zero, one)
}

/// The rotation of a base, which nine numbers say by rows; none of a base that stands.
fn rotation(base: &[f64]) -> Matrix {
    if base.is_empty() {
        return Matrix::identity();
    }
    Matrix::from_fn(|i, j| number(base[3 * i + j]))
}

/// The motion of a body: of one of its points, and its rotation. Sizes are what its numbers could be, whatever cancels.
#[derive(Clone, Copy)]
struct Motion {
    point: Vector,
    acceleration: Vector,
    velocity: Vector,
    turning: Vector,
    size: [f64; 3],
}

fn length(x: &Vector) -> f64 {
    x.map(DoubleDouble::to_f64).norm()
}

impl Motion {
    /// The same motion, told by another point of the body.
    fn at(self, point: Vector) -> Motion {
        let (w, r) = (self.velocity, point - self.point);
        let [acceleration, speed, turning] = self.size;
        let size = acceleration + (turning + speed * speed) * length(&r);
        Motion {
            point,
            acceleration: self.acceleration + self.turning.cross(&r) + w.cross(&w.cross(&r)),
            size: [size, speed, turning],
            ..self
        }
    }

    /// The motion of the next link, which turns about an axis through the point or slides along it.
    fn moved(self, joint: JointType, axis: &Vector, [_, qd, qdd]: [DoubleDouble; 3]) -> Motion {
        let [acceleration, speed, turning] = self.size;
        let (fast, pushed) = (qd.abs().to_f64(), qdd.abs().to_f64());
        let along = axis * qd;
        match joint {
            JointType::Revolute => Motion {
                velocity: self.velocity + along,
                turning: self.turning + self.velocity.cross(&along) + axis * qdd,
                size: [acceleration, speed + fast, turning + speed * fast + pushed],
                ..self
            },
            JointType::Prismatic => Motion {
                acceleration: self.acceleration
                    + self.velocity.cross(&(along + along))
                    + axis * qdd,
                size: [acceleration + 2.0 * speed * fast + pushed, speed, turning],
                ..self
            },
        }
    }
}

/// The force and the moment that the motion of a body takes.
struct Load {
    com: Vector,
    force: Vector,
    moment: Vector,
    /// Sizes of the force and of the moment.
    size: [f64; 2],
}

impl Load {
    fn new(
        motion: Motion,
        pose: &Pose,
        mass: &Value,
        com: &[Value; 3],
        inertia: &[Value; 6],
    ) -> Load {
        let [xx, yy, zz, xy, yz, xz] = inertia.each_ref().map(cell);
        let tensor = Matrix::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let tensor = pose.rotation * tensor * pose.rotation.transpose();
        let com = pose.position + pose.rotation * Vector::from(com.each_ref().map(cell));
        let (w, mass) = (motion.velocity, cell(mass));
        let at_com = motion.at(com);
        let [acceleration, speed, turning] = at_com.size;
        let largest = tensor.map(|x| x.to_f64().abs()).amax();
        Load {
            com,
            force: at_com.acceleration * mass,
            moment: tensor * motion.turning + w.cross(&(tensor * w)),
            size: [
                mass.to_f64() * acceleration,
                largest * (turning + speed * speed),
            ],
        }
    }
}

/// A row at a state: its joint, and the bodies on its link.
struct Link {
    axis: Vector,
    origin: Vector,
    frame: Pose,
    motion: Motion,
    loads: Vec<Load>,
}

/// A force at each joint that moves by itself, and how large its terms are.
pub(super) type Forces = Vec<(DoubleDouble, f64)>;

/// The dynamics of a robot whose cells are numbers. It has no springs, and no friction that falls with the velocity.
pub(super) struct Exact<'a>(pub(super) &'a Robot);

impl Exact<'_> {
    /// The joint, the factor and the offset by which a row moves; a locked one has no joint.
    fn motion(&self, row: usize) -> (Option<usize>, DoubleDouble, DoubleDouble) {
        let Row {
            locked, follows, ..
        } = &self.0.rows[row];
        match (locked, follows) {
            (Some(position), _) => (None, number(0.0), cell(position)),
            (_, Some(of)) => (
                Some(self.0.joint_of(of.leader)),
                cell(&of.factor),
                cell(&of.offset),
            ),
            _ => (Some(self.0.joint_of(row)), number(1.0), number(0.0)),
        }
    }

    fn world(&self) -> Pose {
        let origin = Pose {
            rotation: Matrix::identity(),
            position: Vector::zeros(),
        };
        origin.placed(self.0.placement().map_or(&[][..], core::slice::from_ref))
    }

    /// The motion of the frame in which links are placed, against gravity in the same axes. A base that moves has the first
    /// six velocities u = (v, w) in its own axes, in which its origin has the acceleration dv/dt + w x v.
    fn start(&self, velocities: &[f64], accelerations: &[f64], gravity: Vector) -> Motion {
        let still = Motion {
            point: Vector::zeros(),
            acceleration: -gravity,
            velocity: Vector::zeros(),
            turning: Vector::zeros(),
            size: [length(&gravity), 0.0, 0.0],
        };
        if !self.0.freedoms().has_base() {
            return still;
        }
        let three = |x: &[f64], first: usize| Vector::from_fn(|i, _| number(x[first + i]));
        let [v, w] = [0, 3].map(|first| three(velocities, first));
        let [dv, dw] = [0, 3].map(|first| three(accelerations, first));
        Motion {
            acceleration: dv + w.cross(&v) - gravity,
            velocity: w,
            turning: dw,
            size: [
                length(&gravity) + length(&dv) + length(&w) * length(&v),
                length(&w),
                length(&dw),
            ],
            ..still
        }
    }

    /// The loads of the body of a base that moves, and of bodies of frames on it.
    fn on_base(&self, motion: Motion) -> Vec<Load> {
        let Some(own) = self.0.floating() else {
            return Vec::new();
        };
        let world = self.world();
        let frames = self.0.frames.iter().filter(|frame| frame.on.is_none());
        let fixed =
            frames.filter_map(|frame| Some((world.placed(&frame.places), frame.body.as_ref()?)));
        let bodies = [(world, own)].into_iter().chain(fixed);
        let load = |(pose, Body { mass, com, inertia }): (Pose, &Body)| {
            Load::new(motion, &pose, mass, com, inertia)
        };
        bodies.map(load).collect()
    }

    /// The links in the order of the rows, on a base that moves so; `state` is q, velocities and accelerations.
    fn links(&self, [q, qd, qdd]: [&[f64]; 3], base: Motion) -> Vec<Link> {
        let robot = self.0;
        let world = self.world();
        let mut links: Vec<Link> = Vec::new();
        for (i, row) in robot.rows.iter().enumerate() {
            let parent = robot.parent(i).map(|parent| &links[parent]);
            let (frame, motion) = parent.map_or((world, base), |link| (link.frame, link.motion));
            let (joint, factor, offset) = self.motion(i);
            let of = |x: &[f64], before: usize| {
                joint.map_or(number(0.0), |joint| factor * number(x[joint - before]))
            };
            // Positions are those of the joints alone.
            let position = of(q, robot.freedoms().base) + offset;
            let [speed, push] = [of(qd, 0), of(qdd, 0)];
            let mut frame = frame.placed(&row.at);
            let axis = row.mount.as_ref().map(|mount| {
                let [azimuth, polar] = mount.axis.each_ref().map(turn);
                about_z(azimuth) * about_y(polar)
            });
            let turned = axis.unwrap_or_else(Matrix::identity);
            frame = frame.then(turned, Vector::zeros());
            if robot.convention == Convention::Modified {
                frame = frame.along_x(row);
            }
            let (axis, origin) = (frame.rotation.column(2).into_owned(), frame.position);
            let (theta, d) = match row.joint_type {
                JointType::Revolute => (sum(turn(&row.theta), position.sin_cos()), cell(&row.d)),
                JointType::Prismatic => (turn(&row.theta), cell(&row.d) + position),
            };
            frame = frame.then(about_z(theta), Vector::z() * d);
            if robot.convention == Convention::Standard {
                frame = frame.along_x(row);
            }
            frame = frame.then(turned.transpose(), Vector::zeros());
            let start = match row.joint_type {
                JointType::Revolute => motion.at(origin),
                JointType::Prismatic => motion.at(frame.position),
            };
            let motion = start.moved(row.joint_type, &axis, [position, speed, push]);
            let own = Load::new(motion, &frame, &row.mass, &row.com, &row.inertia);
            let fixed = robot.frames.iter().filter(|fixed| fixed.on == Some(i));
            let fixed =
                fixed.filter_map(|fixed| Some((frame.placed(&fixed.places), fixed.body.as_ref()?)));
            let tool = robot
                .tool
                .as_ref()
                .filter(|_| robot.tip_row() == Some(i))
                .map(|tool| {
                    let place = frame.placed(std::slice::from_ref(&tool.placement));
                    let Body { mass, com, inertia } = &tool.body;
                    Load::new(motion, &place, mass, com, inertia)
                });
            let of_body = |(pose, Body { mass, com, inertia }): (Pose, &Body)| {
                Load::new(motion, &pose, mass, com, inertia)
            };
            links.push(Link {
                axis,
                origin,
                frame,
                motion,
                loads: [own]
                    .into_iter()
                    .chain(fixed.map(of_body))
                    .chain(tool)
                    .collect(),
            });
        }
        links
    }

    /// Whether row k is the row i, or stands on a link that its joint moves.
    fn carries(&self, i: usize, k: usize) -> bool {
        let mut row = Some(k);
        while let Some(k) = row {
            if k == i {
                return true;
            }
            row = self.0.parent(k);
        }
        false
    }

    /// M qdd + V, and G if there is gravity, and F if there is friction.
    fn forces(&self, state: [&[f64]; 3], gravity: Vector, friction: bool) -> Forces {
        let base = self.start(state[1], state[2], gravity);
        let links = self.links(state, base);
        let mut forces = self.at_base(&links, base);
        forces.resize(self.0.dof(), (number(0.0), 0.0));
        for (i, row) in self.0.rows.iter().enumerate() {
            let (Some(joint), factor, _) = self.motion(i) else {
                continue;
            };
            let Link { axis, origin, .. } = &links[i];
            let (mut force, mut size) =
                self.at_joint(row, factor, [state[1][joint], state[2][joint]], friction);
            for (_, link) in links
                .iter()
                .enumerate()
                .filter(|(k, _)| self.carries(i, *k))
            {
                for load in &link.loads {
                    let arm = load.com - origin;
                    let [of_force, of_moment] = load.size;
                    match row.joint_type {
                        JointType::Revolute => {
                            force += axis.dot(&(load.moment + arm.cross(&load.force)));
                            size += length(&arm) * of_force + of_moment;
                        }
                        JointType::Prismatic => {
                            force += axis.dot(&load.force);
                            size += of_force;
                        }
                    }
                }
            }
            forces[joint].0 += factor * force;
            forces[joint].1 += factor.abs().to_f64() * size;
        }
        forces
    }

    /// The six forces of a base that moves: the sum of all forces, and of their moments about its origin.
    fn at_base(&self, links: &[Link], base: Motion) -> Forces {
        if !self.0.freedoms().has_base() {
            return Forces::new();
        }
        let own = self.on_base(base);
        let loads = || own.iter().chain(links.iter().flat_map(|link| &link.loads));
        let force: Vector = loads().map(|load| load.force).sum();
        let moment: Vector = loads()
            .map(|load| load.moment + load.com.cross(&load.force))
            .sum();
        let of_force: f64 = loads().map(|load| load.size[0]).sum();
        let of_moment: f64 = loads()
            .map(|load| load.size[1] + length(&load.com) * load.size[0])
            .sum();
        let sized = |x: &Vector, size: f64| [x.x, x.y, x.z].map(|x| (x, size));
        [sized(&force, of_force), sized(&moment, of_moment)].concat()
    }

    /// The reflected inertia of a row's motor, and friction, at the velocity and the acceleration of its joint or leader.
    fn at_joint(
        &self,
        row: &Row,
        factor: DoubleDouble,
        [qd, qdd]: [f64; 2],
        friction: bool,
    ) -> (DoubleDouble, f64) {
        let ratio = cell(&row.gear_ratio);
        let [speed, push] = [qd, qdd].map(|x| factor * number(x));
        let motor = ratio * ratio * cell(&row.motor_inertia) * push;
        let sign = speed.sign();
        let coulomb = cell(&row.coulomb[usize::from(sign.to_f64() < 0.0)]) * sign;
        let viscous = cell(&row.viscous) * speed;
        let dry = if friction {
            viscous + coulomb
        } else {
            number(0.0)
        };
        let size = [motor, viscous, coulomb].map(|x| x.abs().to_f64());
        (motor + dry, size.iter().sum())
    }

    /// In the axes in which links are placed: of a base that moves its own. `base` is its rotation by rows and its position,
    /// or nothing.
    fn gravity(&self, base: &[f64]) -> Vector {
        rotation(base).transpose() * Vector::from(self.0.gravity.each_ref().map(cell))
    }

    /// The columns of M(q).
    pub(super) fn mass_matrix(&self, q: &[f64]) -> Vec<Forces> {
        let still = vec![0.0; self.0.dof()];
        let columns = (0..self.0.dof()).map(|k| {
            let mut unit = still.clone();
            unit[k] = 1.0;
            self.forces([q, &still, &unit], Vector::zeros(), false)
        });
        columns.collect()
    }

    /// V(q, qd).
    pub(super) fn coriolis_vector(&self, q: &[f64], qd: &[f64]) -> Forces {
        self.forces([q, qd, &vec![0.0; qd.len()]], Vector::zeros(), false)
    }

    /// G(base, q).
    pub(super) fn gravity_vector(&self, base: &[f64], q: &[f64]) -> Forces {
        let still = vec![0.0; self.0.dof()];
        self.forces([q, &still, &still], self.gravity(base), false)
    }

    /// M qdd + V + G + F.
    pub(super) fn inverse_dynamics(&self, base: &[f64], state: [&[f64]; 3]) -> Forces {
        self.forces(state, self.gravity(base), true)
    }

    /// The pose of a frame in the world and its Jacobian by columns.
    pub(super) fn at_frame(
        &self,
        frame: usize,
        base: &[f64],
        q: &[f64],
    ) -> (Pose, Vec<[Vector; 2]>) {
        let (pose, columns) = self.on_standing_base(frame, q);
        let turn = rotation(base);
        let place = Vector::from_fn(|i, _| number(base.get(9 + i).copied().unwrap_or(0.0)));
        let in_world = Pose {
            rotation: turn * pose.rotation,
            position: place + turn * pose.position,
        };
        let axes = [Vector::x(), Vector::y(), Vector::z()];
        let along = axes.map(|axis| [axis, Vector::zeros()]);
        let about = axes.map(|axis| [axis.cross(&pose.position), axis]);
        let of_base = [along, about]
            .concat()
            .into_iter()
            .take(self.0.freedoms().base);
        let joints = columns.into_iter().skip(self.0.freedoms().base);
        let columns = of_base.chain(joints).map(|column| column.map(|x| turn * x));
        (in_world, columns.collect())
    }

    /// As [`Exact::at_frame`], in the axes in which links are placed; nothing of what a base does.
    fn on_standing_base(&self, frame: usize, q: &[f64]) -> (Pose, Vec<[Vector; 2]>) {
        let still = vec![0.0; self.0.dof()];
        let links = self.links(
            [q, &still, &still],
            self.start(&still, &still, Vector::zeros()),
        );
        let frame = &self.0.frames[frame];
        let carrier = frame
            .on
            .map_or_else(|| self.world(), |row| links[row].frame);
        let pose = carrier.placed(&frame.places);
        let mut columns = vec![[Vector::zeros(); 2]; self.0.dof()];
        let moving =
            (0..=frame.on.unwrap_or(0)).filter(|i| frame.on.is_some_and(|on| self.carries(*i, on)));
        for i in moving {
            let (Some(joint), factor, _) = self.motion(i) else {
                continue;
            };
            let (axis, from) = (links[i].axis * factor, links[i].origin);
            let [linear, angular] = match self.0.rows[i].joint_type {
                JointType::Revolute => [axis.cross(&(pose.position - from)), axis],
                JointType::Prismatic => [axis, Vector::zeros()],
            };
            columns[joint] = [columns[joint][0] + linear, columns[joint][1] + angular];
        }
        (pose, columns)
    }
}
