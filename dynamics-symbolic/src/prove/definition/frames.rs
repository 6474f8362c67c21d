//! The frames of all links and of the tip, and the bodies in them.

use super::Definition;
use super::body::Body;
use super::place::Frames;
use super::pose::{Lift, Pose, Position};

impl Definition {
    /// The frames of all rows.
    pub(super) fn frames<R: Lift>(&self, q: &[Position<R>]) -> Vec<Frames<R>> {
        let base = Pose::identity().then_fixed(&self.base);
        self.outward(|i, inner: Option<&Frames<R>>| {
            let base = inner.map_or(base, |inner| inner.link);
            let row = &self.rows[i];
            row.place.frames(&base, row.joint.joint_type, &q[i])
        })
    }

    /// The pose of the tip: the tool's, or else that of the last link.
    pub(super) fn tip<R: Lift>(&self, q: &[Position<R>]) -> Pose<R> {
        let frames = self.frames(q);
        let last = frames.last().expect("a robot has links");
        last.link.then_fixed(&self.tip)
    }

    /// Every body, the row of its link, and the pose of its frame: the links, then the tool.
    pub(super) fn bodies<R: Lift>(&self, q: &[Position<R>]) -> Vec<(usize, &Body, Pose<R>)> {
        let frames = self.frames(q);
        let links = self.rows.iter().zip(&frames).enumerate();
        let links = links.map(|(i, (row, frames))| (i, &row.body, frames.link));
        let tool = self.tool.iter().zip(frames.last());
        let last = self.rows.len() - 1;
        let tool = tool.map(|(body, frames)| (last, body, frames.link.then_fixed(&self.tip)));
        links.chain(tool).collect()
    }

    /// The bodies that can move: a joint that carries them is not locked.
    pub(super) fn moving_bodies<R: Lift>(&self, q: &[Position<R>]) -> Vec<(&Body, Pose<R>)> {
        let can_move = |row: usize| self.carriers(row).any(|k| !self.rows[k].joint.is_locked);
        let bodies = self.bodies(q).into_iter();
        let moving = bodies.filter(|(row, ..)| can_move(*row));
        moving.map(|(_, body, pose)| (body, pose)).collect()
    }
}
