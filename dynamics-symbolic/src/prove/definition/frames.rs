//! Where the frames and the bodies of the arm are.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::body::Body;
use super::pose::{Lift, Pose, Position};
use super::{Definition, Row};
use crate::robot::{Convention, JointType};

impl Definition {
    /// The positions with their derivatives in the direction of joint k.
    pub(super) fn along(&self, k: usize) -> Vec<Position<Dual<Number>>> {
        self.moving(&self.q, &self.unit(k))
    }

    /// The positions of the joints of all rows, from those of the axes.
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

    /// The poses of all link frames in the world: those of rows with a mount where it was written, not where
    /// their cells are.
    pub(super) fn poses<R: Lift>(&self, q: &[Position<R>]) -> Vec<Pose<R>> {
        let mut poses = self.poses_of_cells(q);
        let mut before = None;
        let rows = self.rows.iter().zip(self.positions(q));
        for (pose, (row, position)) in poses.iter_mut().zip(rows) {
            let Some(mount) = &row.mount else {
                continue;
            };
            let joint = match &before {
                Some(before) => Pose::then(before, &mount.joint()),
                None => self.in_world(mount.joint()),
            };
            *pose = joint.then(&moved(row, &position)).then(&mount.back());
            before = Some(*pose);
        }
        poses
    }

    /// The poses of the frames that the cells describe.
    fn poses_of_cells<R: Lift>(&self, q: &[Position<R>]) -> Vec<Pose<R>> {
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

    /// A frame of frame 0, in the world.
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
        let links = self.poses_of_cells(q);
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

    /// Every body and the pose of its frame: the links from the base outwards, then the tool.
    pub(super) fn bodies<R: Lift>(&self, q: &[Position<R>]) -> Vec<(&Body, Pose<R>)> {
        let poses = self.poses(q);
        let tip = self.tip(&poses);
        let links = self.rows.iter().map(|row| &row.body).zip(poses);
        let tool = self.tool.iter().map(|tool| (&tool.body, tip));
        links.chain(tool).collect()
    }

    /// How many of the bodies cannot move, for all joints up to theirs are locked.
    pub(super) fn resting_bodies(&self) -> usize {
        let is_locked = |row: &&Row| row.locked.is_some();
        self.rows.iter().take_while(is_locked).count()
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

/// Rz(q), or Tz(q). If the position of a follower does not include its offset, Rz(offset) comes first.
fn moved<R: Lift>(row: &Row, position: &Position<R>) -> Pose<R> {
    let (zero, one) = (R::lift(Number::ZERO), R::lift(Number::ONE));
    let (s, c) = (R::lift(row.offset.0), R::lift(row.offset.1));
    match row.joint_type {
        JointType::Revolute => {
            Pose::screw_z((s, c), zero).then(&Pose::screw_z((position.s, position.c), zero))
        }
        JointType::Prismatic => Pose::screw_z((zero, one), position.q),
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
