//! How the base and all joints move with the degrees of freedom.

use super::super::assignment::{Number, multiple, turned};
use super::super::dual::Dual;
use super::configuration::{BaseVelocity, Configuration, Twice, random_pose};
use super::pose::{Lift, Position};
use super::{Definition, Row, Vector};
use crate::exact::{SplitMix64, circle_point, common_angles};
use crate::linear::Vector3;

impl Definition {
    /// The velocities of the base among the speeds, if it moves.
    pub(super) fn velocity_of_base<R: Lift>(&self, speeds: &[R]) -> Option<BaseVelocity<R>> {
        self.floating.as_ref()?;
        let vector = |first: usize| Vector3([0, 1, 2].map(|k| speeds[first + k]));
        Some([vector(0), vector(3)])
    }

    /// The configuration with its derivative, if the degrees of freedom have these speeds.
    pub(super) fn moving<R: Lift>(
        &self,
        q: &Configuration<R>,
        speeds: &[R],
    ) -> Configuration<Dual<R>> {
        let rows = q.joints.iter().zip(&self.rows);
        let joint = |(q, row): (&Position<R>, &Row)| q.moving(row.joint.speed(speeds));
        let still = [Vector3::splat(R::lift(Number::ZERO)); 2];
        Configuration {
            base: q
                .base
                .moving(self.velocity_of_base(speeds).unwrap_or(still)),
            joints: rows.map(joint).collect(),
        }
    }

    /// The configuration with its derivative in the direction of one degree of freedom.
    pub(super) fn along(&self, k: usize) -> Configuration<Dual<Number>> {
        self.moving(&self.q, &self.unit(k))
    }

    /// The configuration displaced in two directions at once.
    pub(super) fn along_both(&self, j: usize, k: usize) -> Configuration<Twice> {
        let displaced = self.moving(&self.along(j), &self.unit(k));
        let displacement = |k: usize| self.velocity_of_base(&self.unit(k));
        match (displacement(j), displacement(k)) {
            (Some(first), Some(second)) => Configuration {
                base: self.q.base.displaced([first, second]),
                ..displaced
            },
            _ => displaced,
        }
    }

    /// The configuration with two steps in time.
    pub(super) fn accelerating(&self) -> Configuration<Twice> {
        let rates = self.qd.iter().zip(&self.qdd);
        let speeds: Vec<_> = rates.map(|(&qd, &qdd)| Dual::new(qd, qdd)).collect();
        self.moving(&self.moving(&self.q, &self.qd), &speeds)
    }

    /// The speeds if one degree of freedom alone moves, at unit speed.
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
