//! The energies.

use super::super::assignment::{HALF, Number};
use super::Definition;
use super::configuration::Configuration;
use super::pose::Lift;
use crate::linear::Vector3;

impl Definition {
    /// T = sum 1/2 (m c'.c' + w.I w) + sum 1/2 r^2 J_m qd^2, where c' is the
    /// derivative of c and w in the link frame that of the rotation: [w]x = R^T R'.
    pub(super) fn kinetic_energy<R: Lift>(&self, q: &Configuration<R>, qd: &[R]) -> R {
        let mut twice = R::lift(Number::ZERO);
        for (_, body, pose) in self.bodies(&self.moving(q, qd)) {
            let velocity = Vector3(body.center(&pose).0.map(|x| x.derivative));
            let w = pose.angular_velocity();
            let linear = R::lift(body.mass) * velocity.dot(velocity);
            twice = twice + linear + w.dot(body.tensor().apply(w));
        }
        for row in &self.rows {
            let speed = row.joint.speed(qd);
            twice = twice + R::lift(row.reflected) * speed * speed;
        }
        let neglected = self.neglected(|| {
            let twists = self.twists(q, qd);
            self.inertia_forms(&twists, &twists)
        });
        R::lift(HALF) * (twice - neglected)
    }

    /// A value for all parameters that are neglected, by the values for a unit of each parameter.
    fn neglected<R: Lift>(&self, units: impl Fn() -> Vec<R>) -> R {
        let zero = R::lift(Number::ZERO);
        if self.neglected.is_empty() {
            return zero;
        }
        let terms = self.neglected.iter().zip(units());
        terms.fold(zero, |sum, (&part, unit)| sum + R::lift(part) * unit)
    }

    /// U, of gravity and of springs.
    pub(super) fn potential_energy<R: Lift>(&self, q: &Configuration<R>) -> R {
        self.energy_of_gravity(q) + self.energy_of_springs(q)
    }

    /// U_k = sum 1/2 stiffness (q - rest)^2, of the joints that move, by themselves or with others.
    pub(super) fn energy_of_springs<R: Lift>(&self, q: &Configuration<R>) -> R {
        let mut energy = R::lift(Number::ZERO);
        for (row, position) in self.rows.iter().zip(&q.joints) {
            if let Some((stiffness, rest)) = row.spring {
                let stretch = position.q - R::lift(rest);
                energy = energy + R::lift(HALF * stiffness) * stretch * stretch;
            }
        }
        energy
    }

    /// U_g = -sum m g.c, of the bodies that can move.
    pub(super) fn energy_of_gravity<R: Lift>(&self, q: &Configuration<R>) -> R {
        let gravity = Vector3(self.gravity.0.map(R::lift));
        let bodies = self.moving_bodies(q).into_iter();
        let terms = bodies.map(|(body, pose)| R::lift(body.mass) * gravity.dot(body.center(&pose)));
        let zero = R::lift(Number::ZERO);
        let energy = terms.fold(zero, |energy, term| energy - term);
        energy - self.neglected(|| self.unit_potentials(q))
    }
}
