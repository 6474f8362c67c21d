//! What each base parameter adds to the joint forces of a motion, in numbers.

use super::reals::{Reals, sin_cos};
use crate::derive::base::{Geometry, base_parameters, columns, geometry, unit};
use crate::derive::place;
use crate::linear::Vector3;
use crate::robot::{Grouping, Interpretation, JointType, Parameter, Robot};
use crate::spatial::{Acceleration, Body, Force, Joint, Turn};

/// The force of each joint that moves.
pub(super) type Forces = Vec<f64>;

/// An arm as its base parameters.
pub(super) struct Arm {
    dof: usize,
    geometry: Geometry<f64>,
    links: Vec<Link>,
    gravity: Vector3<f64>,
    /// Row and name of each base parameter.
    pub(super) columns: Vec<(usize, Parameter)>,
    /// The body that it is, or the inertia of the motor.
    parts: Vec<Result<Body<f64>, f64>>,
}

struct Link {
    /// Of the joint variable's cell, where the joint turns.
    theta: Turn<f64>,
    motion: Option<Motion>,
}

/// How the joint of a link moves: one that moves by itself has the factor 1, and no offset.
#[derive(Clone, Copy)]
struct Motion {
    /// The joint by which it moves, of those that move by themselves.
    joint: usize,
    factor: f64,
    offset: f64,
}

impl Motion {
    fn of(robot: &Robot, i: usize) -> Option<Self> {
        match &robot.rows[i].follows {
            Some(coupling) => Some(Motion {
                joint: robot.joint_of(coupling.leader),
                factor: coupling.factor.to_f64(&[]),
                offset: coupling.offset.to_f64(&[]),
            }),
            None => robot.rows[i].is_free().then(|| Motion {
                joint: robot.joint_of(i),
                factor: 1.0,
                offset: 0.0,
            }),
        }
    }
}

impl Arm {
    pub(super) fn new(robot: &Robot, grouping: &Grouping) -> Self {
        let cells = &mut Reals;
        let geometry = geometry(cells, robot);
        let values = base_parameters(cells, robot, grouping);
        let columns = columns(grouping);
        let part = |(&(i, parameter), &value): (&(usize, Parameter), &f64)| {
            let unit = unit(grouping, &geometry, i, parameter);
            unit.map(|unit| unit.times(value)).ok_or(value)
        };
        let parts = columns.iter().zip(&values).map(part).collect();
        let links = robot.rows.iter().enumerate().map(|(i, row)| Link {
            theta: cells.sin_cos(&row.theta).into(),
            motion: Motion::of(robot, i),
        });
        Arm {
            dof: robot.dof(),
            links: links.collect(),
            geometry,
            gravity: place::gravity(cells, robot),
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
        let (qd, qdd) = (self.of_rows(qd), self.of_rows(qdd));
        let accelerations = tree.outward(base, |i, before| before.enter(&joints[i], qd[i], qdd[i]));
        let leave = |j: usize, force: Force<f64>| force.leave(&joints[j]);
        let part = |(&(i, _), part): (&(usize, Parameter), &Result<Body<f64>, f64>)| {
            let mut forces = vec![0.0; joints.len()];
            match part {
                Ok(body) => {
                    let force = accelerations[i].force(body);
                    tree.along_carriers(i, force, leave, |j, force| {
                        forces[j] = force.along(joints[j].joint_type);
                    });
                }
                Err(motor) => forces[i] = motor * qdd[i],
            }
            self.of_joints(forces)
        };
        self.columns.iter().zip(&self.parts).map(part).collect()
    }

    /// For the joint of every row, 0 where it is locked.
    fn of_rows(&self, of_joints: &[f64]) -> Vec<f64> {
        let value = |motion: Motion| motion.factor * of_joints[motion.joint];
        let links = self.links.iter();
        links.map(|link| link.motion.map_or(0.0, value)).collect()
    }

    /// For the joints that move by themselves, what those that follow them feel included.
    fn of_joints(&self, of_rows: Vec<f64>) -> Forces {
        let mut forces = vec![0.0; self.dof()];
        for (link, force) in self.links.iter().zip(of_rows) {
            if let Some(Motion { joint, factor, .. }) = link.motion {
                forces[joint] += factor * force;
            }
        }
        forces
    }
}

impl Arm {
    fn joint(&self, i: usize, q: &[f64]) -> Joint<f64> {
        let (still, link) = (self.geometry.joint(i), &self.links[i]);
        let Some(motion) = link.motion else {
            return still;
        };
        let q = motion.factor * q[motion.joint] + motion.offset;
        match still.joint_type {
            JointType::Revolute => {
                let (s, c) = sin_cos(q);
                let turn = link.theta.plus(Turn { s, c });
                Joint { turn, ..still }
            }
            JointType::Prismatic => Joint { slide: q, ..still },
        }
    }
}
