//! How joints move.
//!
//! The position of every joint is k q_j + c, where q_j is the position of a free joint. A free joint has k = 1
//! and c = 0, a joint that follows another one has the factor and the offset of its coupling, and a joint that is
//! locked at c has k = 0. Lists of positions have one for each row. Velocities, and derivatives by positions and
//! velocities, belong to the free joints.

use super::super::assignment::{Assignment, Number};
use super::pose::{Lift, Position};
use crate::robot::{JointType, Robot};

/// The motion of one joint.
pub(super) struct Joint {
    pub(super) is_revolute: bool,
    pub(super) is_free: bool,
    pub(super) is_locked: bool,
    /// The free joint by which it moves: any, if it is locked.
    pub(super) leader: usize,
    /// k
    pub(super) factor: Number,
    /// c
    pub(super) offset: Number,
    /// Its position. The sine and the cosine of a follower are those without the offset.
    pub(super) position: Position<Number>,
    /// The sign of its velocity, and exp(-(qd/v)^2).
    pub(super) sign: Number,
    pub(super) exponential: Number,
}

impl Joint {
    pub(super) fn new(point: &mut Assignment, robot: &Robot, index: usize) -> Self {
        let row = &robot.rows[index];
        let mut joint = Joint {
            is_revolute: row.joint_type == JointType::Revolute,
            is_free: row.is_free(),
            is_locked: row.locked.is_some(),
            leader: 0,
            factor: Number::ZERO,
            offset: Number::ZERO,
            position: Position::at((Number::ZERO, Number::ONE), Number::ZERO),
            sign: Number::ZERO,
            exponential: Number::ZERO,
        };
        if let Some(position) = &row.locked {
            match joint.is_revolute {
                true => (joint.position.s, joint.position.c) = point.angle(position),
                false => joint.position.q = point.cell(position),
            }
            return joint;
        }
        let leader = row
            .follows
            .as_ref()
            .map_or(index, |coupling| coupling.leader);
        joint.leader = robot.joint_of(leader);
        point.note([joint.leader as u64]);
        let mut own = joint.leader;
        joint.factor = Number::ONE;
        if let Some(coupling) = &row.follows {
            let before = robot.rows[..index].iter();
            own = robot.dof() + before.filter(|row| row.follows.is_some()).count();
            joint.factor = point.cell(&coupling.factor);
            joint.offset = point.cell(&coupling.offset);
        }
        let q = joint.factor * point.joints()[joint.leader].q + joint.offset;
        let own = &point.joints()[own];
        joint.position = Position::at(own.sin_cos, q);
        (joint.sign, joint.exponential) = (own.sign, own.stribeck);
        joint
    }

    /// Its speed, if the free joints have these.
    pub(super) fn speed<R: Lift>(&self, speeds: &[R]) -> R {
        let zero = R::lift(Number::ZERO);
        let leader = speeds.get(self.leader);
        leader.map_or(zero, |&speed| R::lift(self.factor) * speed)
    }

    pub(super) fn turns(&self) -> bool {
        self.is_revolute && !self.is_locked
    }
}
