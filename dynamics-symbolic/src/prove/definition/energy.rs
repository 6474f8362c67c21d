//! The energies.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::pose::{Lift, Pose, Position};
use super::regressor::{polar, twist};
use super::{Definition, Row};
use crate::linear::{Matrix3, Ring, Symmetric3, Vector3};

impl Definition {
    /// T = sum 1/2 (m c'.c' + w.I w) + sum 1/2 r^2 J_m qd^2, where c' is the
    /// derivative of c and w in the link frame that of the rotation: [w]x = R^T R'.
    pub(super) fn kinetic_energy<R: Lift>(&self, q: &[Position<R>], qd: &[R]) -> R {
        let moving: Vec<_> = q.iter().zip(qd).map(|(q, &qd)| q.moving(qd)).collect();
        let mut twice = R::lift(Number::ZERO);
        for (row, pose) in self.rows.iter().zip(self.poses(&moving)) {
            let velocity = Vector3(center(row, &pose).0.map(|x| x.derivative));
            let w = angular_velocity(&pose.rotation);
            twice =
                twice + R::lift(row.mass) * velocity.dot(velocity) + w.dot(inertia(row).apply(w));
        }
        for ((_, row), &qd) in self.joints().zip(qd) {
            twice = twice + R::lift(row.reflected) * qd * qd;
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
        for ((i, _), &qd) in self.joints().zip(qd) {
            twice = twice + R::lift(self.neglected[i][10]) * qd * qd;
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

    /// U = -sum m g.c, of the links that can move.
    pub(super) fn potential_energy<R: Lift>(&self, q: &[Position<R>]) -> R {
        let gravity = Vector3(self.gravity.0.map(R::lift));
        let mut energy = R::lift(Number::ZERO);
        let links = self.rows.iter().zip(self.poses(q));
        for (row, pose) in links.skip_while(|(row, _)| row.locked.is_some()) {
            energy = energy - R::lift(row.mass) * gravity.dot(center(row, &pose));
        }
        energy - self.neglected_potential(q)
    }
}

/// The centre of mass in the base.
fn center<R: Lift>(row: &Row, pose: &Pose<R>) -> Vector3<R> {
    pose.rotation.apply(Vector3(row.com.0.map(R::lift))) + pose.origin
}

/// The inertia tensor about the centre of mass, in the link frame.
fn inertia<R: Lift>(row: &Row) -> Symmetric3<R> {
    Symmetric3 {
        xx: R::lift(row.inertia.xx),
        yy: R::lift(row.inertia.yy),
        zz: R::lift(row.inertia.zz),
        xy: R::lift(row.inertia.xy),
        yz: R::lift(row.inertia.yz),
        xz: R::lift(row.inertia.xz),
    }
}

/// w of [w]x = R^T R', in the axes of the turned frame.
pub(super) fn angular_velocity<R: Ring>(rotation: &Matrix3<Dual<R>>) -> Vector3<R> {
    let value = Matrix3(rotation.0.map(|row| row.map(|x| x.value)));
    let rate = Matrix3(rotation.0.map(|row| row.map(|x| x.derivative)));
    let entry = |i: usize, j: usize| value.column(i).dot(rate.column(j));
    Vector3::new(entry(2, 1), entry(0, 2), entry(1, 0))
}
