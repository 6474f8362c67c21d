//! The rows of the table in the field.

use super::super::assignment::{Assignment, Number};
use super::body::Body;
use super::friction::Friction;
use super::placement::Placement;
use super::pose::{Lift, Pose};
use crate::robot::{self, JointType};

/// A row of the table in the field.
pub(super) struct Row {
    pub(super) joint_type: JointType,
    /// Sine and cosine of alpha.
    pub(super) twist: (Number, Number),
    /// Sine and cosine of theta; of an angle that follows another, of theta and the offset.
    pub(super) turn: (Number, Number),
    /// The offset alone, where a mount says where the joint is: a turn beside those that are written there.
    pub(super) offset: (Number, Number),
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
    pub(super) mount: Option<Mount>,
    /// Whether the joint moves by itself.
    pub(super) is_free: bool,
}

/// Where the joint and its link frame are as they were written.
pub(super) struct Mount {
    /// Each in the one before it, the first in the link frame before.
    places: Vec<Placement>,
    /// Sine and cosine of the azimuth and the polar angle of the axis.
    axis: [(Number, Number); 2],
    /// The link frame in the frame of the row's cells, to which the derivation's base parameters refer.
    frame: Vec<Placement>,
}

impl Mount {
    fn new(point: &mut Assignment, mount: &robot::Mount) -> Self {
        let mut places = |places: &[robot::Placement]| {
            let places = places.iter().map(|place| Placement::new(point, place));
            places.collect()
        };
        Mount {
            places: places(&mount.places),
            frame: places(&mount.frame),
            axis: mount.axis.each_ref().map(|angle| point.angle(angle)),
        }
    }

    /// The joint's frame in the link frame before, without its turn: the places, then Rz(azimuth) Ry(polar).
    pub(super) fn joint<R: Lift>(&self) -> Pose<R> {
        let places = self.places.iter().map(Placement::pose);
        let place = places.fold(Pose::identity(), |pose: Pose<R>, place| pose.then(&place));
        place.then(&self.axis())
    }

    fn axis<R: Lift>(&self) -> Pose<R> {
        let none = (Number::ZERO, Number::ONE);
        let [azimuth, polar] = self.axis;
        Placement::turned([none, polar, azimuth]).pose()
    }

    /// The link frame in the frame that turns with the joint: Ry(-polar) Rz(-azimuth).
    pub(super) fn back<R: Lift>(&self) -> Pose<R> {
        let Pose { rotation, origin } = self.axis();
        Pose {
            rotation: rotation.transpose(),
            origin,
        }
    }

    /// The link frame in the frame of the row's cells.
    pub(super) fn frame<R: Lift>(&self) -> Pose<R> {
        let places = self.frame.iter().map(Placement::pose);
        places.fold(Pose::identity(), |pose: Pose<R>, place| pose.then(&place))
    }
}

impl Row {
    pub(super) fn new(point: &mut Assignment, row: &robot::Row) -> Self {
        let leader = row
            .follows
            .as_ref()
            .map_or(0, |coupling| coupling.leader + 1);
        let kind = [row.joint_type as usize, leader, row.locked.is_some().into()];
        point.note(kind.map(|word| word as u64));
        let ratio = point.cell(&row.gear_ratio);
        let is_turned = row.joint_type == JointType::Revolute;
        let follows = row.follows.as_ref().filter(|_| is_turned);
        let offset = follows.map_or(robot::Value::zero(), |coupling| coupling.offset.clone());
        let (turn, offset) = match &row.mount {
            None => {
                let turn = point.angle(&(row.theta.clone() + offset));
                (turn, (Number::ZERO, Number::ONE))
            }
            Some(_) => {
                let [theta, offset] = [&row.theta, &offset].map(|angle| point.angle(angle));
                (sum(theta, offset), offset)
            }
        };
        Row {
            joint_type: row.joint_type,
            twist: point.angle(&row.alpha),
            turn,
            offset,
            a: point.cell(&row.a),
            d: point.cell(&row.d),
            body: Body::new(point, &row.mass, &row.com, &row.inertia),
            has_motor: row.has_motor(),
            reflected: ratio * ratio * point.cell(&row.motor_inertia),
            friction: Friction::new(point, row),
            spring: row
                .spring
                .as_ref()
                .map(|spring| (point.cell(&spring.stiffness), point.cell(&spring.rest))),
            locked: row
                .locked
                .as_ref()
                .map(|position| locked(point, row.joint_type, position)),
            mount: row.mount.as_ref().map(|mount| Mount::new(point, mount)),
            is_free: row.is_free(),
        }
    }
}

/// Sine and cosine of the sum of two angles.
fn sum((s, c): (Number, Number), (t, d): (Number, Number)) -> (Number, Number) {
    (s * d + c * t, c * d - s * t)
}

/// The position of a locked joint. Lengths have no sine.
fn locked(
    point: &mut Assignment,
    joint_type: JointType,
    position: &robot::Value,
) -> ((Number, Number), Number) {
    match joint_type {
        JointType::Revolute => (point.angle(position), Number::ZERO),
        JointType::Prismatic => ((Number::ZERO, Number::ONE), point.cell(position)),
    }
}
