//! Positions of joints and poses of links, over the field or over dual numbers.

use super::super::assignment::{JointPoint, Number};
use super::super::dual::Dual;
use super::{Definition, Row};
use crate::linear::{Matrix3, Ring, Vector3};
use crate::robot::{Convention, JointType};

/// A ring that the table's numbers are part of.
pub(super) trait Lift: Ring {
    /// The number in this ring.
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

/// The position of a joint: sine and cosine of an angle, or a displacement.
#[derive(Clone, Copy)]
pub(super) struct Position<R> {
    s: R,
    c: R,
    q: R,
}

impl Position<Number> {
    pub(super) fn new(joint: &JointPoint) -> Self {
        Position::at(joint.sin_cos, joint.q)
    }

    pub(super) fn at((s, c): (Number, Number), q: Number) -> Self {
        Position { s, c, q }
    }
}

impl<R: Ring> Position<R> {
    /// q itself.
    pub(super) fn value(&self) -> R {
        self.q
    }

    /// The position with its derivative where q changes at the rate `rate`.
    pub(super) fn moving(self, rate: R) -> Position<Dual<R>> {
        Position {
            s: Dual::new(self.s, self.c * rate),
            c: Dual::new(self.c, -(self.s * rate)),
            q: Dual::new(self.q, rate),
        }
    }
}

/// A homogeneous transform.
#[derive(Clone, Copy)]
pub(super) struct Pose<R> {
    pub(super) rotation: Matrix3<R>,
    pub(super) origin: Vector3<R>,
}

impl<R: Lift> Pose<R> {
    /// A frame that is the other frame.
    pub(super) fn identity() -> Self {
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        Pose::screw_x((zero, one), zero)
    }

    /// Rz(angle) Tz(d)
    fn screw_z((s, c): (R, R), d: R) -> Self {
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        Pose {
            rotation: Matrix3([[c, -s, zero], [s, c, zero], [zero, zero, one]]),
            origin: Vector3::new(zero, zero, d),
        }
    }

    /// Rx(angle) Tx(a)
    pub(super) fn screw_x((s, c): (R, R), a: R) -> Self {
        let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
        Pose {
            rotation: Matrix3([[one, zero, zero], [zero, c, -s], [zero, s, c]]),
            origin: Vector3::new(a, zero, zero),
        }
    }

    /// The frame that `next` describes in this one.
    pub(super) fn then(&self, next: &Pose<R>) -> Pose<R> {
        Pose {
            rotation: self.rotation.product(&next.rotation),
            origin: self.rotation.apply(next.origin) + self.origin,
        }
    }
}

impl Definition {
    /// The positions with their derivatives in the direction of joint k.
    pub(super) fn along(&self, k: usize) -> Vec<Position<Dual<Number>>> {
        let rate = |i: usize| if i == k { Number::ONE } else { Number::ZERO };
        let joints = self.q.iter().enumerate();
        joints.map(|(i, q)| q.moving(rate(i))).collect()
    }

    /// The positions of the joints of all rows, from those of the joints that move.
    fn positions<R: Lift>(&self, q: &[Position<R>]) -> Vec<Position<R>> {
        let mut moving = q.iter();
        let position = |row: &Row| match &row.locked {
            None => moving.next().copied(),
            Some(((s, c), q)) => Some(Position {
                s: R::lift(*s),
                c: R::lift(*c),
                q: R::lift(*q),
            }),
        };
        self.rows.iter().map_while(position).collect()
    }

    /// The poses of all link frames in the world.
    pub(super) fn poses<R: Lift>(&self, q: &[Position<R>]) -> Vec<Pose<R>> {
        let mut poses: Vec<Pose<R>> = Vec::with_capacity(self.rows.len());
        for (row, position) in self.rows.iter().zip(self.positions(q)) {
            let transform = transform(self.convention, row, &position);
            poses.push(match poses.last() {
                Some(previous) => previous.then(&transform),
                None => self.in_world(transform),
            });
        }
        poses
    }

    /// A frame that is told in frame 0.
    fn in_world<R: Lift>(&self, pose: Pose<R>) -> Pose<R> {
        match &self.base {
            Some(base) => base.pose().then(&pose),
            None => pose,
        }
    }

    /// The pose of the tip behind those of all links: the tool's, or else the last of them.
    pub(super) fn tip<R: Lift>(&self, poses: &[Pose<R>]) -> Pose<R> {
        let last = poses.last().expect("a robot has links");
        match &self.tool {
            Some(tool) => last.then(&tool.placement.pose()),
            None => *last,
        }
    }

    /// The poses of the frames on the joints' own axes, after Rz(theta) Tz(d).
    pub(super) fn joint_frames<R: Lift>(&self, q: &[Position<R>]) -> Vec<Pose<R>> {
        let links = self.poses(q);
        if self.convention == Convention::Modified {
            return links;
        }
        let positions = self.positions(q);
        let frame = |i: usize| {
            let (screw_z, _) = screws(&self.rows[i], &positions[i]);
            match i {
                0 => self.in_world(screw_z),
                _ => links[i - 1].then(&screw_z),
            }
        };
        (0..self.rows.len()).map(frame).collect()
    }
}

/// A_i of the table.
fn transform<R: Lift>(convention: Convention, row: &Row, position: &Position<R>) -> Pose<R> {
    let (screw_z, screw_x) = screws(row, position);
    match convention {
        Convention::Standard => screw_z.then(&screw_x),
        Convention::Modified => screw_x.then(&screw_z),
    }
}

/// Rz(theta) Tz(d) and Rx(alpha) Tx(a)
fn screws<R: Lift>(row: &Row, position: &Position<R>) -> (Pose<R>, Pose<R>) {
    let lift = R::lift;
    let (s, c) = (lift(row.turn.0), lift(row.turn.1));
    let (turn, d) = match row.joint_type {
        JointType::Revolute => {
            // sin(theta + q), cos(theta + q)
            let sine = s * position.c + c * position.s;
            let cosine = c * position.c - s * position.s;
            ((sine, cosine), lift(row.d))
        }
        JointType::Prismatic => ((s, c), lift(row.d) + position.q),
    };
    let screw_z = Pose::screw_z(turn, d);
    let screw_x = Pose::screw_x((lift(row.twist.0), lift(row.twist.1)), lift(row.a));
    (screw_z, screw_x)
}
