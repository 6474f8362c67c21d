//! The part of each base parameter in the joint forces of a motion, in numbers.

use super::reals::{Reals, sin_cos};
use crate::derive::base::{Geometry, base_parameters, columns, geometry, unit};
use crate::derive::place;
use crate::derive::rows::Moved;
use crate::linear::Vector3;
use crate::mechanism::Mechanism;
use crate::robot::{Grouping, Parameter};
use crate::spatial::{Acceleration, AxisMotion, Body, Force, Joint, Turn};

/// The force of each joint that moves.
pub(super) type Forces = Vec<f64>;

/// An arm as its base parameters.
pub(super) struct Arm {
    dof: usize,
    geometry: Geometry<f64>,
    /// How the joints move; `None` of one that stands still.
    motions: Vec<Option<Moved<f64>>>,
    gravity: Vector3<f64>,
    /// Link and name of each base parameter.
    pub(super) columns: Vec<(usize, Parameter)>,
    /// The body that it is, or the inertia of the motor.
    parts: Vec<Result<Body<f64>, f64>>,
}

impl Arm {
    pub(super) fn new(arm: &Mechanism, grouping: &Grouping) -> Self {
        let cells = &mut Reals;
        let geometry = geometry(cells, arm);
        let values = base_parameters(cells, arm, grouping);
        let columns = columns(grouping);
        let part = |(&(i, parameter), &value): (&(usize, Parameter), &f64)| {
            let unit = unit(grouping, &geometry, i, parameter);
            unit.map(|unit| unit.times(value)).ok_or(value)
        };
        let parts = columns.iter().zip(&values).map(part).collect();
        let motions = (0..arm.joints.len()).map(|i| Moved::of(cells, arm, i));
        Arm {
            dof: arm.dof(),
            motions: motions.collect(),
            geometry,
            gravity: place::gravity(cells, arm),
            columns,
            parts,
        }
    }

    pub(super) fn dof(&self) -> usize {
        self.dof
    }

    /// The columns of M that each parameter adds.
    pub(super) fn mass_matrix(&self, q: &[f64]) -> Vec<Vec<Forces>> {
        let n = self.dof();
        let still = vec![0.0; n];
        let mut parts = vec![Vec::with_capacity(n); self.parts.len()];
        for j in 0..n {
            let mut unit = still.clone();
            unit[j] = 1.0;
            let column = self.forces(q, &still, &unit, false);
            for (part, column) in parts.iter_mut().zip(column) {
                part.push(column);
            }
        }
        parts
    }

    /// The joint forces that each parameter adds to those of a motion, with gravity or without.
    pub(super) fn forces(&self, q: &[f64], qd: &[f64], qdd: &[f64], gravity: bool) -> Vec<Forces> {
        let tree = &self.geometry.tree;
        let joints: Vec<_> = (0..tree.len()).map(|i| self.joint(i, q)).collect();
        let gravity = if gravity {
            self.gravity
        } else {
            Vector3::splat(0.0)
        };
        let base = Acceleration::of_base(0.0, gravity);
        let (qd, qdd) = (self.of_all(qd), self.of_all(qdd));
        let accelerations = tree.outward(base, |i, before| before.enter(&joints[i], qd[i], qdd[i]));
        let leave = |j: usize, force: Force<f64>| force.leave(&joints[j]);
        let part = |(&(i, _), part): (&(usize, Parameter), &Result<Body<f64>, f64>)| {
            let mut forces = vec![0.0; joints.len()];
            match part {
                Ok(body) => {
                    let force = accelerations[i].force(body);
                    tree.along_carriers(i, force, leave, |j, force| {
                        forces[j] = force.along(joints[j].axis_motion);
                    });
                }
                Err(motor) => forces[i] = motor * qdd[i],
            }
            self.of_free(forces)
        };
        self.columns.iter().zip(&self.parts).map(part).collect()
    }

    /// For every joint; 0 for one that stands still.
    fn of_all(&self, of_free: &[f64]) -> Vec<f64> {
        let value = |motion: Moved<f64>| motion.factor * of_free[motion.joint];
        let motions = self.motions.iter();
        motions.map(|motion| motion.map_or(0.0, value)).collect()
    }

    /// For the joints that move by themselves, what those that follow them feel included.
    fn of_free(&self, of_all: Vec<f64>) -> Forces {
        let mut forces = vec![0.0; self.dof()];
        for (motion, force) in self.motions.iter().zip(of_all) {
            if let Some(Moved { joint, factor, .. }) = motion {
                forces[*joint] += factor * force;
            }
        }
        forces
    }

    fn joint(&self, i: usize, q: &[f64]) -> Joint<f64> {
        let still = self.geometry.joint(i);
        let Some(motion) = self.motions[i] else {
            return still;
        };
        let q = motion.factor * q[motion.joint];
        match still.axis_motion {
            AxisMotion::Turns => Joint {
                turn: motion.turn.plus(Turn::from(sin_cos(q))),
                ..still
            },
            AxisMotion::Slides => Joint {
                slide: q + motion.offset,
                ..still
            },
        }
    }
}
