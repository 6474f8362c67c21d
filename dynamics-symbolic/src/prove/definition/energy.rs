//! The energies.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::Definition;
use super::pose::{Lift, Position};
use super::twist::{angular_velocity, polar, twist};
use crate::linear::Vector3;

impl Definition {
    /// T = sum 1/2 (m c'.c' + w.I w) + sum 1/2 r^2 J_m qd^2, where c' is the
    /// derivative of c and w in the link frame that of the rotation: [w]x = R^T R'.
    pub(super) fn kinetic_energy<R: Lift>(&self, q: &[Position<R>], qd: &[R]) -> R {
        let moving = self.moving(q, qd);
        let mut twice = R::lift(Number::ZERO);
        for (body, pose) in self.bodies(&moving) {
            let velocity = Vector3(body.center(&pose).0.map(|x| x.derivative));
            let w = angular_velocity(&pose.rotation);
            let linear = R::lift(body.mass) * velocity.dot(velocity);
            twice = twice + linear + w.dot(body.tensor().apply(w));
        }
        for (axis, row) in self.axes() {
            let speed = axis.speed(qd);
            twice = twice + R::lift(row.reflected) * speed * speed;
        }
        R::lift(self.half) * (twice - self.neglected_energy(&moving, qd))
    }

    /// Twice the kinetic energy of the parameters that are neglected.
    fn neglected_energy<R: Lift>(&self, q: &[Position<Dual<R>>], qd: &[R]) -> R {
        let mut twice = R::lift(Number::ZERO);
        if self.neglected.is_empty() {
            return twice;
        }
        for (frame, parameters) in self.joint_frames(q).iter().zip(&self.neglected) {
            let twist = twist(frame);
            for (&part, energy) in parameters.iter().zip(polar(twist, twist)) {
                twice = twice + R::lift(part) * energy;
            }
        }
        for (axis, _) in self.axes() {
            let speed = axis.speed(qd);
            twice = twice + R::lift(self.neglected[axis.row][10]) * speed * speed;
        }
        twice
    }

    /// The potential energy of the parameters that are neglected: -m g.p - g.R h.
    fn neglected_potential<R: Lift>(&self, q: &[Position<R>]) -> R {
        let gravity = Vector3(self.gravity.0.map(R::lift));
        let mut energy = R::lift(Number::ZERO);
        if self.neglected.is_empty() {
            return energy;
        }
        for (frame, parameters) in self.joint_frames(q).iter().zip(&self.neglected) {
            let [.., x, y, z, mass, _] = parameters.map(R::lift);
            let moment = frame.rotation.apply(Vector3::new(x, y, z));
            energy = energy - gravity.dot(moment) - mass * gravity.dot(frame.origin);
        }
        energy
    }

    /// U, of gravity and of springs.
    pub(super) fn potential_energy<R: Lift>(&self, q: &[Position<R>]) -> R {
        self.energy_of_gravity(q) + self.energy_of_springs(q)
    }

    /// U_k = sum 1/2 stiffness (q - rest)^2, of the joints that move, by themselves or with others.
    pub(super) fn energy_of_springs<R: Lift>(&self, q: &[Position<R>]) -> R {
        let axes = self.axes().zip(q);
        axes.fold(R::lift(Number::ZERO), |energy, ((_, row), q)| {
            let Some((stiffness, rest)) = row.spring else {
                return energy;
            };
            let stretch = q.value() - R::lift(rest);
            energy + R::lift(self.half * stiffness) * stretch * stretch
        })
    }

    /// U_g = -sum m g.c, of the bodies that can move.
    pub(super) fn energy_of_gravity<R: Lift>(&self, q: &[Position<R>]) -> R {
        let gravity = Vector3(self.gravity.0.map(R::lift));
        let mut energy = R::lift(Number::ZERO);
        for (body, pose) in self.bodies(q).iter().skip(self.resting_bodies()) {
            energy = energy - R::lift(body.mass) * gravity.dot(body.center(pose));
        }
        energy - self.neglected_potential(q)
    }
}
