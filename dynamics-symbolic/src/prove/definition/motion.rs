//! How all joints move with the free ones.

use super::super::assignment::{Number, multiple, turned};
use super::configuration::{Configuration, random_pose};
use super::pose::Position;
use super::{Definition, Row, Vector};
use crate::exact::{SplitMix64, circle_point, common_angles};

impl Definition {
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
    /// of the circle, by its [`multiples`](Self::multiples), and a value. A base that moves is anywhere.
    pub(super) fn random_configuration(
        &self,
        multiples: &[Vec<i64>],
        random: &mut SplitMix64,
    ) -> Configuration<Number> {
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
        let joints = self.rows.iter().zip(multiples).map(position).collect();
        let base = match self.floating {
            Some(_) => random_pose(random),
            None => self.q.base,
        };
        Configuration { base, joints }
    }
}
