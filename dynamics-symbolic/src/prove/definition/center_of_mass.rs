//! The centre of mass: sum m c / sum m over the links and the tool, but for links that cannot move.

use super::super::assignment::Number;
use super::derivatives::transpose;
use super::pose::{Lift, Position};
use super::{Definition, Matrix, Vector};
use crate::linear::Vector3;

impl Definition {
    /// The centre of mass; none of an arm without mass.
    pub(super) fn center_of_mass(&self) -> Option<Vector> {
        let mass = self.total_mass().inverse()?;
        let moment = self.first_moment(&self.q);
        Some(moment.0.iter().map(|&x| x * mass).collect())
    }

    /// Its derivatives by the joint positions, by rows.
    pub(super) fn center_of_mass_jacobian(&self) -> Option<Vector> {
        let mass = self.total_mass().inverse()?;
        let column = |j: usize| -> Vector {
            let moment = self.first_moment(&self.along(j));
            moment.0.iter().map(|x| x.derivative * mass).collect()
        };
        let columns: Matrix = (0..self.dof()).map(column).collect();
        Some(transpose(&columns).concat())
    }

    fn total_mass(&self) -> Number {
        let bodies = self.bodies(&self.q);
        let moving = bodies.iter().skip(self.resting_bodies());
        moving.fold(Number::ZERO, |sum, (body, _)| sum + body.mass)
    }

    fn first_moment<R: Lift>(&self, q: &[Position<R>]) -> Vector3<R> {
        let none = Vector3::splat(R::lift(Number::ZERO));
        let bodies = self.bodies(q);
        let moving = bodies.iter().skip(self.resting_bodies());
        moving.fold(none, |sum, (body, pose)| {
            sum + body.center(pose) * R::lift(body.mass)
        })
    }
}
