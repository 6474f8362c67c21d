//! How all joints move with the free ones.

use super::super::assignment::{Number, multiple, turned};
use super::super::dual::Dual;
use super::pose::{Lift, Position};
use super::{Definition, Row, Vector};
use crate::exact::{SplitMix64, circle_point, common_angles};

impl Definition {
    /// Positions with their derivatives, if the free joints have these speeds.
    pub(super) fn moving<R: Lift>(
        &self,
        q: &[Position<R>],
        speeds: &[R],
    ) -> Vec<Position<Dual<R>>> {
        let rows = q.iter().zip(&self.rows);
        rows.map(|(q, row)| q.moving(row.joint.speed(speeds)))
            .collect()
    }

    /// The positions with their derivatives in the direction of the free joint k.
    pub(super) fn along(&self, k: usize) -> Vec<Position<Dual<Number>>> {
        self.moving(&self.q, &self.unit(k))
    }

    /// The speeds of the free joints if joint k alone moves, at unit speed.
    pub(super) fn unit<R: Lift>(&self, k: usize) -> Vec<R> {
        let speed = |i: usize| if i == k { Number::ONE } else { Number::ZERO };
        (0..self.dof()).map(|i| R::lift(speed(i))).collect()
    }

    /// The forces on the free joints by forces on all joints: a displacement of a joint moves its followers by
    /// their factors (virtual work).
    pub(super) fn on_free_joints(&self, forces: impl Iterator<Item = Number>) -> Vector {
        let mut sums = vec![Number::ZERO; self.dof()];
        for (row, force) in self.rows.iter().zip(forces) {
            if let Some(sum) = sums.get_mut(row.joint.leader) {
                *sum = *sum + row.joint.factor * force;
            }
        }
        sums
    }

    /// The last joint that turns among those that carry a row.
    pub(super) fn turning_carrier(&self, row: usize) -> Option<usize> {
        self.carriers(row)
            .skip(1)
            .find(|&k| self.rows[k].joint.turns())
    }

    /// For every joint that turns, its angle as whole multiples of independent angles of its leader.
    pub(super) fn multiples(&self) -> Vec<Vec<i64>> {
        let mut multiples = vec![Vec::new(); self.rows.len()];
        for leader in 0..self.dof() {
            let rows = self.rows.iter().enumerate();
            let turning = rows.filter(|(_, row)| row.joint.leader == leader && row.joint.turns());
            let (places, factors): (Vec<_>, Vec<_>) = turning
                .map(|(place, row)| (place, row.joint.factor))
                .unzip();
            for (place, angle) in places.into_iter().zip(common_angles(&factors)) {
                multiples[place] = angle;
            }
        }
        multiples
    }

    /// Random positions of the free joints, and those of all joints that belong to them. Every joint has a point
    /// of the circle, by its [`multiples`](Self::multiples), and a value.
    pub(super) fn random_positions(
        &self,
        multiples: &[Vec<i64>],
        random: &mut SplitMix64,
    ) -> Vec<Position<Number>> {
        let values: Vec<_> = (0..self.dof()).map(|_| Number::random(random)).collect();
        let angles: Vec<Vec<_>> = (0..self.dof())
            .map(|_| self.rows.iter().map(|_| circle_point(random)).collect())
            .collect();
        let position = |(row, multiples): (&Row, &Vec<i64>)| {
            let joint = &row.joint;
            if joint.is_locked {
                return joint.position;
            }
            let turns = angles[joint.leader].iter().zip(multiples);
            let turns = turns.map(|(&angle, &n)| multiple(angle, n));
            let point = turns.fold((Number::ZERO, Number::ONE), turned);
            Position::at(point, joint.speed(&values) + joint.offset)
        };
        self.rows.iter().zip(multiples).map(position).collect()
    }
}
