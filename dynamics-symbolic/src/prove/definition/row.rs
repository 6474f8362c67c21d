//! The rows of the table in the field.

use super::super::assignment::{Assignment, Number};
use super::body::Body;
use super::friction::Friction;
use crate::robot::{self, Interpretation, JointType};

/// A row of the table in the field.
pub(super) struct Row {
    pub(super) joint_type: JointType,
    /// Sine and cosine of alpha.
    pub(super) twist: (Number, Number),
    /// Sine and cosine of theta.
    pub(super) turn: (Number, Number),
    pub(super) a: Number,
    pub(super) d: Number,
    pub(super) body: Body,
    pub(super) has_motor: bool,
    /// r^2 J_m
    pub(super) reflected: Number,
    pub(super) friction: Friction,
    /// Stiffness and rest of the spring, where the joint has one.
    pub(super) spring: Option<(Number, Number)>,
    /// Where the joint is locked: sine, cosine and value of its position.
    pub(super) locked: Option<((Number, Number), Number)>,
}

impl Row {
    pub(super) fn new(point: &mut Assignment, row: &robot::Row) -> Self {
        let ratio = point.value(&row.gear_ratio);
        Row {
            joint_type: row.joint_type,
            twist: point.sin_cos(&row.alpha),
            turn: point.sin_cos(&row.theta),
            a: point.value(&row.a),
            d: point.value(&row.d),
            body: Body::new(point, &row.mass, &row.com, &row.inertia),
            has_motor: row.has_motor(),
            reflected: ratio * ratio * point.value(&row.motor_inertia),
            friction: Friction::new(point, row),
            spring: row
                .spring
                .as_ref()
                .map(|spring| (point.value(&spring.stiffness), point.value(&spring.rest))),
            locked: row
                .locked
                .as_ref()
                .map(|position| locked(point, row.joint_type, position)),
        }
    }
}

/// The position of a locked joint. Lengths have no sine.
fn locked(
    point: &mut Assignment,
    joint_type: JointType,
    position: &robot::Value,
) -> ((Number, Number), Number) {
    match joint_type {
        JointType::Revolute => (point.sin_cos(position), Number::ZERO),
        JointType::Prismatic => ((Number::ZERO, Number::ONE), point.value(position)),
    }
}
