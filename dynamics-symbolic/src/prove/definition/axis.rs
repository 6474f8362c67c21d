//! The axes of an arm: of the joints that move by themselves, and of those that follow them.
//!
//! A follower of joint j with the factor k is at k q_j + c, and moves at the speed k qd_j. Positions are
//! those of all axes; velocities, and what is derived by a position or a velocity, those of the joints.

use super::super::assignment::{Assignment, JointPoint, Number, multiple, turned};
use super::super::dual::Dual;
use super::pose::{Lift, Position};
use super::{Definition, Row, Vector};
use crate::exact::{SplitMix64, circle_point, common_angles};
use crate::robot::{self, JointType, Robot};

/// One axis of the arm.
#[derive(Clone, Copy)]
pub(super) struct Axis {
    /// Its row of the table.
    pub(super) row: usize,
    /// The joint by which it moves.
    pub(super) joint: usize,
    /// Its speed over that joint's: 1 of a joint that moves by itself.
    pub(super) factor: Number,
    /// Where it is while that joint is at zero.
    offset: Number,
    /// The sign of its velocity, and exp(-(qd/v)^2).
    pub(super) sign: Number,
    pub(super) exponential: Number,
}

impl Axis {
    /// Its speed, where the joints have these.
    pub(super) fn speed<R: Lift>(&self, of_joints: &[R]) -> R {
        R::lift(self.factor) * of_joints[self.joint]
    }
}

/// All axes and their positions, from the base outwards.
pub(super) fn axes(point: &mut Assignment, robot: &Robot) -> (Vec<Axis>, Vec<Position<Number>>) {
    let mut joints = 0..;
    let mut followers = robot.dof()..;
    let rows = robot.rows.iter().enumerate();
    let moving = rows.filter(|(_, row)| row.locked.is_none());
    let axis = |(row, cells): (usize, &robot::Row)| match &cells.follows {
        None => {
            let joint = joints.next().unwrap_or_default();
            let own = point.joints()[joint];
            let axis = self::axis(row, joint, (Number::ONE, Number::ZERO), own);
            (axis, Position::at(own.sin_cos, own.q))
        }
        Some(coupling) => {
            let [factor, offset] =
                [&coupling.factor, &coupling.offset].map(|value| point.cell(value));
            let joint = robot.joint_of(coupling.leader);
            let own = point.joints()[followers.next().unwrap_or_default()];
            let q = factor * point.joints()[joint].q + offset;
            // The offset of an angle is a part of the constant one.
            let axis = self::axis(row, joint, (factor, offset), own);
            (axis, Position::at(own.sin_cos, q))
        }
    };
    moving.map(axis).unzip()
}

fn axis(row: usize, joint: usize, (factor, offset): (Number, Number), own: JointPoint) -> Axis {
    Axis {
        row,
        joint,
        factor,
        offset,
        sign: own.sign,
        exponential: own.stribeck,
    }
}

impl Definition {
    /// Every axis with its row.
    pub(super) fn axes(&self) -> impl Iterator<Item = (&Axis, &Row)> {
        self.axes.iter().map(|axis| (axis, &self.rows[axis.row]))
    }

    /// For every axis that turns, its angle as whole multiples of independent angles of the joint that it belongs to.
    pub(super) fn multiples(&self) -> Vec<Vec<i64>> {
        let mut multiples = vec![Vec::new(); self.axes.len()];
        for joint in 0..self.dof() {
            let is_turned = |axis: &Axis| self.rows[axis.row].joint_type == JointType::Revolute;
            let axes = self.axes.iter().enumerate();
            let turning = axes.filter(|(_, axis)| axis.joint == joint && is_turned(axis));
            let (places, factors): (Vec<_>, Vec<_>) =
                turning.map(|(place, axis)| (place, axis.factor)).unzip();
            for (place, of_axis) in places.into_iter().zip(common_angles(&factors)) {
                multiples[place] = of_axis;
            }
        }
        multiples
    }

    /// Random positions of the joints, and all axes where they belong to these. Every axis has a point of the
    /// circle, by its [`multiples`](Self::multiples), and a value.
    pub(super) fn random_positions(
        &self,
        multiples: &[Vec<i64>],
        random: &mut SplitMix64,
    ) -> Vec<Position<Number>> {
        let joints: Vec<_> = (0..self.dof()).map(|_| Number::random(random)).collect();
        let angles: Vec<Vec<_>> = (0..self.dof())
            .map(|_| self.axes.iter().map(|_| circle_point(random)).collect())
            .collect();
        let positions = self.axes.iter().zip(multiples);
        let position = |(axis, multiples): (&Axis, &Vec<i64>)| {
            let turns = angles[axis.joint].iter().zip(multiples);
            let turns = turns.map(|(&angle, &n)| multiple(angle, n));
            let point = turns.fold((Number::ZERO, Number::ONE), turned);
            Position::at(point, axis.factor * joints[axis.joint] + axis.offset)
        };
        positions.map(position).collect()
    }

    /// Positions with their derivatives, where the joints have these speeds.
    pub(super) fn moving<R: Lift>(
        &self,
        q: &[Position<R>],
        speeds: &[R],
    ) -> Vec<Position<Dual<R>>> {
        let axes = q.iter().zip(&self.axes);
        axes.map(|(q, axis)| q.moving(axis.speed(speeds))).collect()
    }

    /// The speeds of the joints where joint k alone moves, at unit speed.
    pub(super) fn unit<R: Lift>(&self, k: usize) -> Vec<R> {
        let speed = |i: usize| if i == k { Number::ONE } else { Number::ZERO };
        (0..self.dof()).map(|i| R::lift(speed(i))).collect()
    }

    /// What the joints feel of forces on all axes: a displacement of joint j moves its followers by their
    /// factors (virtual work).
    pub(super) fn felt(&self, of_axes: impl Iterator<Item = Number>) -> Vector {
        let mut felt = vec![Number::ZERO; self.dof()];
        for (axis, force) in self.axes.iter().zip(of_axes) {
            felt[axis.joint] = felt[axis.joint] + axis.factor * force;
        }
        felt
    }

    /// What joint j feels of the inertia of a motor at that row, for a unit of both and of acceleration.
    pub(super) fn share_of_motor(&self, row: usize, j: usize) -> Number {
        let axis = self.axes.iter().find(|axis| axis.row == row);
        let factor = axis.filter(|axis| axis.joint == j).map(|axis| axis.factor);
        factor.map_or(Number::ZERO, |factor| factor * factor)
    }
}
