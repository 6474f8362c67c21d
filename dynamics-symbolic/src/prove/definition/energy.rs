//! The energies.

use super::super::assignment::{HALF, Number};
use super::Definition;
use super::configuration::Configuration;
use super::parameters::Twist;
use super::pose::Lift;
use crate::linear::Vector3;

/// The velocities of everything that has inertia.
pub(super) struct Velocities<R> {
    /// The velocity of each body's centre of mass, and its angular velocity in its own axes.
    bodies: Vec<(Vector3<R>, Vector3<R>)>,
    joints: Vec<R>,
    /// The twists of the links, if parameters are neglected.
    twists: Vec<Twist<R>>,
}

impl Definition {
    /// The velocities at which T is, if the degrees of freedom have these speeds.
    pub(super) fn velocities<R: Lift>(&self, q: &Configuration<R>, qd: &[R]) -> Velocities<R> {
        let bodies = self.bodies(&self.moving(q, qd)).into_iter();
        let bodies = bodies.map(|(_, body, pose)| {
            let linear = Vector3(body.center(&pose).0.map(|x| x.derivative));
            (linear, pose.angular_velocity())
        });
        let twists = if self.neglected.is_empty() {
            Vec::new()
        } else {
            self.twists(q, qd)
        };
        Velocities {
            bodies: bodies.collect(),
            joints: self.rows.iter().map(|row| row.joint.speed(qd)).collect(),
            twists,
        }
    }

    /// The polar form of 2 T = sum m c'.c' + w.I w + sum r^2 J_m qd^2, where c' is the derivative of c and w in the link
    /// frame that of the rotation: [w]x = R^T R'. Velocities are linear in qd, so that x' M y has this value at those of x
    /// and of y.
    pub(super) fn inertia_form<R: Lift>(&self, x: &Velocities<R>, y: &Velocities<R>) -> R {
        let mut sum = R::lift(Number::ZERO);
        let velocities = x.bodies.iter().zip(&y.bodies);
        for (body, (&(v, w), &(other_v, other_w))) in self.all_bodies().zip(velocities) {
            let linear = R::lift(body.mass) * v.dot(other_v);
            sum = sum + linear + w.dot(body.tensor().apply(other_w));
        }
        let speeds = x.joints.iter().zip(&y.joints);
        for (row, (&speed, &other)) in self.rows.iter().zip(speeds) {
            sum = sum + R::lift(row.reflected) * speed * other;
        }
        sum - self.neglected(|| self.inertia_forms(&x.twists, &y.twists))
    }

    /// T
    pub(super) fn kinetic_energy<R: Lift>(&self, q: &Configuration<R>, qd: &[R]) -> R {
        let velocities = self.velocities(q, qd);
        R::lift(HALF) * self.inertia_form(&velocities, &velocities)
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
