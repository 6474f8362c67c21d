//! The rows of the table in the field.

use super::super::assignment::{Assignment, Number};
use super::body::Body;
use super::friction::Friction;
use super::joint::Joint;
use super::place::{self, Place};
use crate::robot::{self, JointType, Robot};

// Each cell of a row is read here, in `place`, in `body` or in `friction`.
const _: () = assert!(robot::Row::CELLS == 11);

/// A row of the table in the field.
pub(super) struct Row {
    /// The row that carries it.
    pub(super) parent: Option<usize>,
    pub(super) joint: Joint,
    pub(super) place: Place,
    pub(super) body: Body,
    /// Whether it has a motor that moves.
    pub(super) has_motor: bool,
    /// r^2 J_m
    pub(super) reflected: Number,
    pub(super) friction: Friction,
    /// Stiffness and rest of the spring, if the joint has one and moves.
    pub(super) spring: Option<(Number, Number)>,
}

impl Row {
    pub(super) fn new(point: &mut Assignment, robot: &Robot, index: usize) -> Self {
        let row = &robot.rows[index];
        let moves = row.locked.is_none();
        let is_revolute = row.joint_type == JointType::Revolute;
        let parent = place::parent(row, index);
        point.note([moves, is_revolute, row.mount.is_some()].map(u64::from));
        point.note([parent.map_or(0, |parent| 1 + parent as u64)]);
        let ratio = point.cell(&row.gear_ratio);
        let spring = row.spring.as_ref().filter(|_| moves);
        Row {
            parent,
            joint: Joint::new(point, robot, index),
            place: Place::new(point, robot.convention, row),
            body: Body::new(point, &row.body()),
            has_motor: row.has_motor() && moves,
            reflected: ratio * ratio * point.cell(&row.motor_inertia),
            friction: Friction::new(point, row),
            spring: spring.map(|spring| (point.cell(&spring.stiffness), point.cell(&spring.rest))),
        }
    }
}
