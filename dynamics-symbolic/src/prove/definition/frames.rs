//! The frames of all links and of the tip, and the bodies in them.

use super::super::assignment::{Assignment, Number};
use super::Definition;
use super::body::Body;
use super::configuration::Configuration;
use super::place::{self, Frames};
use super::pose::{Lift, Pose};
use crate::robot::{self, Robot};

/// A frame that is fixed to the link of a row, or to the base.
pub(super) struct Frame {
    /// `None` for the base.
    row: Option<usize>,
    /// In the link frame or frame 0; `None` where it is that.
    place: Option<Pose<Number>>,
}

/// A body that is fixed to a link, or to a base that moves.
pub(super) struct FixedBody {
    /// `None` for the base.
    row: Option<usize>,
    /// As of a [`Frame`].
    place: Option<Pose<Number>>,
    body: Body,
}

impl Frame {
    /// The tip: the tool at the place that a file says, or in a table on the only row that carries no other.
    pub(super) fn tip(point: &mut Assignment, robot: &Robot) -> Option<Frame> {
        let rows = robot.rows.iter().enumerate();
        let parents: Vec<_> = rows.map(|(i, row)| place::parent(row, i)).collect();
        let mut leaves = (0..parents.len()).filter(|&i| !parents.contains(&Some(i)));
        let mut mounts = robot.rows.iter().map(|row| row.mount.as_ref()).enumerate();
        let (row, places) = if robot.rows.iter().any(|row| row.mount.is_some()) {
            mounts.find_map(|(row, mount)| Some((row, Some(mount?.tip.as_ref()?))))?
        } else {
            let only = leaves.next().filter(|_| leaves.next().is_none());
            (only?, None)
        };
        let behind = places.map(|places| place::product(point, places));
        let tool = robot.tool.as_ref();
        let tool = tool.map(|tool| place::placement(point, &tool.placement));
        let place = behind.map_or(tool, |behind| Some(behind.then_fixed(&tool)));
        let row = Some(row);
        Some(Frame { row, place })
    }

    /// The named frames.
    pub(super) fn named(point: &mut Assignment, robot: &Robot) -> Vec<Frame> {
        let frames = robot.frames.iter().map(|frame| {
            point.note([frame.on.map_or(0, |row| row as u64 + 1)]);
            Frame {
                row: frame.on,
                place: Some(place::product(point, &frame.places)),
            }
        });
        frames.collect()
    }
}

impl FixedBody {
    /// The tool at the tip and the bodies of frames. Bodies on a base that stands do not move.
    pub(super) fn all(point: &mut Assignment, robot: &Robot) -> Vec<FixedBody> {
        let tool = robot.tool.as_ref().and_then(|tool| {
            let Frame { row, place } = Frame::tip(point, robot)?;
            Some(FixedBody {
                row: Some(row?),
                place,
                body: Body::new(point, &tool.body),
            })
        });
        let base_stands = robot.floating().is_none();
        let mut fixed = |frame: &robot::Frame| {
            let (row, body) = (frame.on, frame.body.as_ref()?);
            if row.is_none() && base_stands {
                return None;
            }
            point.note([row.map_or(u64::MAX, |row| row as u64)]);
            let place = Some(place::product(point, &frame.places));
            Some(FixedBody {
                row,
                place,
                body: Body::new(point, body),
            })
        };
        let of_frames = robot.frames.iter().filter_map(&mut fixed);
        tool.into_iter().chain(of_frames).collect()
    }
}

impl Definition {
    /// The frames of all rows.
    pub(super) fn frames<R: Lift>(&self, q: &Configuration<R>) -> Vec<Frames<R>> {
        self.outward(|i, inner: Option<&Frames<R>>| {
            let base = inner.map_or(q.base, |inner| inner.link);
            let row = &self.rows[i];
            row.place.frames(&base, row.joint.is_revolute, &q.joints[i])
        })
    }

    /// The pose of a frame.
    pub(super) fn pose<R: Lift>(&self, frame: &Frame, q: &Configuration<R>) -> Pose<R> {
        let link = frame.row.map_or(q.base, |row| self.frames(q)[row].link);
        link.then_fixed(&frame.place)
    }

    /// Every body, the row of its link, and the pose of its frame: the links, a base that moves, then what is fixed to them.
    pub(super) fn bodies<R: Lift>(
        &self,
        q: &Configuration<R>,
    ) -> Vec<(Option<usize>, &Body, Pose<R>)> {
        let frames = self.frames(q);
        let links = self.rows.iter().zip(&frames).enumerate();
        let links = links.map(|(i, (row, frames))| (Some(i), &row.body, frames.link));
        let base = self.floating.iter().map(|body| (None, body, q.base));
        let fixed = self
            .fixed_bodies
            .iter()
            .map(|FixedBody { row, place, body }| {
                let link = row.map_or(q.base, |row| frames[row].link);
                (*row, body, link.then_fixed(place))
            });
        links.chain(base).chain(fixed).collect()
    }

    /// The bodies in the same order.
    pub(super) fn all_bodies(&self) -> impl Iterator<Item = &Body> {
        let links = self.rows.iter().map(|row| &row.body);
        let fixed = self.fixed_bodies.iter().map(|fixed| &fixed.body);
        links.chain(&self.floating).chain(fixed)
    }

    /// The parameters of what is fixed to the link of a row or to the base, about the origin of the frame in which the link
    /// frame is at `link`.
    pub(super) fn parameters_fixed_to(
        &self,
        row: Option<usize>,
        link: &Pose<Number>,
    ) -> impl Iterator<Item = [Number; 11]> {
        let here = self
            .fixed_bodies
            .iter()
            .filter(move |fixed| fixed.row == row);
        here.map(|fixed| fixed.body.parameters(&link.then_fixed(&fixed.place)))
    }

    /// The bodies that can move: the base moves, or a joint that carries them is not locked.
    pub(super) fn moving_bodies<R: Lift>(&self, q: &Configuration<R>) -> Vec<(&Body, Pose<R>)> {
        let is_free = |row: usize| self.carriers(row).any(|k| !self.rows[k].joint.is_locked);
        let can_move = |row: Option<usize>| self.floating.is_some() || row.is_some_and(is_free);
        let bodies = self.bodies(q).into_iter();
        let moving = bodies.filter(|(row, ..)| can_move(*row));
        moving.map(|(_, body, pose)| (body, pose)).collect()
    }
}
