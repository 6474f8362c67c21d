//! What each base parameter adds to the joint forces of a motion, in numbers.

use super::reals::{Reals, sin_cos};
use crate::derive::base::{Grouping, LinkGeometry, base_parameters, columns, geometry, unit};
use crate::derive::inertia::{Body, Turn, enter_x, enter_z, leave_x, leave_z};
use crate::linear::Vector3;
use crate::robot::{Interpretation, JointType, Parameter, Robot};

type Vector = Vector3<f64>;

/// The force of each joint that moves.
pub(super) type Forces = Vec<f64>;

/// An arm as its base parameters.
pub(super) struct Arm {
    links: Vec<Link>,
    gravity: Vector,
    /// Row and name of each base parameter.
    pub(super) columns: Vec<(usize, Parameter)>,
    /// The body that it is, or the inertia of the motor.
    parts: Vec<Result<Body<f64>, f64>>,
}

struct Link {
    geometry: LinkGeometry<f64>,
    /// Of the joint variable's cell, where the joint turns.
    theta: Turn<f64>,
    /// The joint, of those that move.
    joint: Option<usize>,
}

/// A joint at a position: how vectors pass.
#[derive(Clone, Copy)]
struct Place {
    turn: Turn<f64>,
    twist: Turn<f64>,
    /// The origin in the previous frame.
    origin: Vector,
}

impl Place {
    fn enter(&self, v: Vector) -> Vector {
        enter_z(self.turn, enter_x(self.twist, v))
    }

    fn leave(&self, v: Vector) -> Vector {
        leave_x(self.twist, leave_z(self.turn, v))
    }
}

/// The motion of a link, its acceleration less that of gravity.
#[derive(Clone, Copy)]
struct Motion {
    w: Vector,
    wd: Vector,
    a: Vector,
}

impl Arm {
    pub(super) fn new(robot: &Robot, grouping: &Grouping) -> Self {
        let cells = &mut Reals;
        let geometry = geometry(cells, robot);
        let values = base_parameters(cells, robot, grouping);
        let columns = columns(grouping);
        let part = |(&(i, parameter), &value): (&(usize, Parameter), &f64)| {
            let unit = unit(grouping, &geometry, i, parameter, (0.0, 1.0));
            unit.map(|unit| unit.times(value)).ok_or(value)
        };
        let parts = columns.iter().zip(&values).map(part).collect();
        let mut joints = 0..;
        let links = geometry.iter().zip(&robot.rows).map(|(geometry, row)| {
            let (s, c) = cells.sin_cos(&row.theta);
            Link {
                geometry: *geometry,
                theta: Turn { s, c },
                joint: row.locked.is_none().then(|| joints.next()).flatten(),
            }
        });
        Arm {
            links: links.collect(),
            gravity: Vector3([0, 1, 2].map(|k| Reals.value(&robot.gravity[k]))),
            columns,
            parts,
        }
    }

    pub(super) fn dof(&self) -> usize {
        self.links
            .iter()
            .filter(|link| link.joint.is_some())
            .count()
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
        let places: Vec<_> = self.links.iter().map(|link| link.place(q)).collect();
        let motions = self.motions(&places, qd, qdd, gravity);
        let part = |(&(i, _), part): (&(usize, Parameter), &Result<Body<f64>, f64>)| {
            let mut forces = vec![0.0; qd.len()];
            match (part, self.links[i].joint) {
                (Ok(body), _) => {
                    self.hand_inwards(&places, i, wrench(body, &motions[i]), &mut forces)
                }
                (Err(motor), Some(joint)) => forces[joint] = motor * qdd[joint],
                (Err(_), None) => {}
            }
            forces
        };
        self.columns.iter().zip(&self.parts).map(part).collect()
    }

    fn motions(&self, places: &[Place], qd: &[f64], qdd: &[f64], gravity: bool) -> Vec<Motion> {
        let rest = Vector3::splat(0.0);
        let mut motion = Motion {
            w: rest,
            wd: rest,
            a: if gravity { -self.gravity } else { rest },
        };
        let links = self.links.iter().zip(places);
        let outward = |(link, place): (&Link, &Place)| {
            let Motion { w, wd, a } = motion;
            let r = place.origin;
            let a = place.enter(a + wd.cross(r) + w.cross(w.cross(r)));
            let (w, wd) = (place.enter(w), place.enter(wd));
            motion = Motion { w, wd, a };
            if let Some(j) = link.joint {
                let across = w.cross(Vector3::new(0.0, 0.0, qd[j]));
                match link.geometry.joint_type {
                    JointType::Revolute => {
                        motion.wd = wd + across;
                        motion.wd.0[2] += qdd[j];
                        motion.w.0[2] += qd[j];
                    }
                    JointType::Prismatic => {
                        motion.a = a + across * 2.0;
                        motion.a.0[2] += qdd[j];
                    }
                }
            }
            motion
        };
        links.map(outward).collect()
    }

    /// The forces of joints up to link i that supply a wrench on it.
    fn hand_inwards(
        &self,
        places: &[Place],
        i: usize,
        (mut f, mut n): (Vector, Vector),
        forces: &mut Forces,
    ) {
        for (link, place) in self.links[..=i].iter().zip(places).rev() {
            if let Some(joint) = link.joint {
                forces[joint] = match link.geometry.joint_type {
                    JointType::Revolute => n[2],
                    JointType::Prismatic => f[2],
                };
            }
            f = place.leave(f);
            n = place.leave(n) + place.origin.cross(f);
        }
    }
}

impl Link {
    fn place(&self, q: &[f64]) -> Place {
        let geometry = &self.geometry;
        let (mut turn, mut origin) = (geometry.turn, geometry.offset(0.0));
        match (self.joint, geometry.joint_type) {
            (None, _) => {}
            (Some(j), JointType::Revolute) => {
                let (s, c) = sin_cos(q[j]);
                turn = self.theta.plus(Turn { s, c });
            }
            (Some(j), JointType::Prismatic) => {
                origin = origin + leave_x(geometry.twist, Vector3::new(0.0, 0.0, q[j]));
            }
        }
        Place {
            turn,
            twist: geometry.twist,
            origin,
        }
    }
}

/// f = m a + wd x h + w x (w x h), n = J wd + w x (J w) + h x a.
fn wrench(body: &Body<f64>, motion: &Motion) -> (Vector, Vector) {
    let Motion { w, wd, a } = *motion;
    let (h, j) = (body.moment, &body.inertia);
    let force = a * body.mass + wd.cross(h) + w.cross(w.cross(h));
    let moment = j.apply(wd) + w.cross(j.apply(w)) + h.cross(a);
    (force, moment)
}
