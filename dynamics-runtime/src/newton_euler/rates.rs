//! The first two derivatives of the joint torques along a motion.
//!
//! Newton-Euler in the base frame, as it stands in textbooks, over jets: of every vector its value and
//! its first two derivatives by time, of every product those by Leibniz's rule.

use core::ops::{Add, Mul};

use nalgebra::{Matrix3, SVector, Vector3};

use super::NewtonEuler;
use super::link::Link;
use super::pose::Pose;
use crate::JointType;

/// A value and its first two derivatives.
type Jet<X> = [X; 3];

/// (a b)'' = a'' b + 2 a' b' + a b'', for any product.
fn product<A: Copy, B: Copy, C: Add<Output = C> + Mul<f64, Output = C>>(
    of: impl Fn(A, B) -> C,
    a: Jet<A>,
    b: Jet<B>,
) -> Jet<C> {
    [
        of(a[0], b[0]),
        of(a[0], b[1]) + of(a[1], b[0]),
        of(a[0], b[2]) + of(a[1], b[1]) * 2.0 + of(a[2], b[0]),
    ]
}

fn sum<X: Copy + Add<Output = X>>(a: Jet<X>, b: Jet<X>) -> Jet<X> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

type Vector = Jet<Vector3<f64>>;

const REST: Vector = [Vector3::new(0.0, 0.0, 0.0); 3];

fn cross(a: Vector, b: Vector) -> Vector {
    product(|a: Vector3<f64>, b: Vector3<f64>| a.cross(&b), a, b)
}

fn dot(a: Vector, b: Vector) -> Jet<f64> {
    product(|a: Vector3<f64>, b: Vector3<f64>| a.dot(&b), a, b)
}

fn times(a: Vector, k: Jet<f64>) -> Vector {
    product(|a: Vector3<f64>, k: f64| a * k, a, k)
}

fn apply(m: Jet<Matrix3<f64>>, v: Vector) -> Vector {
    product(|m: Matrix3<f64>, v: Vector3<f64>| m * v, m, v)
}

fn chained(a: Jet<Matrix3<f64>>, b: Jet<Matrix3<f64>>) -> Jet<Matrix3<f64>> {
    product(|a: Matrix3<f64>, b: Matrix3<f64>| a * b, a, b)
}

fn minus(v: Vector) -> Vector {
    v.map(|x| -x)
}

fn fixed(v: Vector3<f64>) -> Vector {
    [v, Vector3::zeros(), Vector3::zeros()]
}

/// A frame and its motion, in the base frame.
#[derive(Clone, Copy)]
struct Moving {
    rotation: Jet<Matrix3<f64>>,
    position: Vector,
    velocity: Vector,
    acceleration: Vector,
    /// Acceleration of the origin, less that of gravity.
    linear: Vector,
}

/// A link, and what its motion takes.
struct Loaded {
    axis: Vector,
    origin: Vector,
    center: Vector,
    force: Vector,
    moment: Vector,
}

impl Loaded {
    const NOTHING: Loaded = Loaded {
        axis: REST,
        origin: REST,
        center: REST,
        force: REST,
        moment: REST,
    };
}

impl Moving {
    /// The frame of the next link: `pose` is where it is in this one, `qd` and `qdd` how it moves.
    fn next(&self, link: &Link, pose: &Pose, qd: Jet<f64>, qdd: Jet<f64>) -> Moving {
        let spin = Vector3::z().cross_matrix();
        let along = pose.rotation.column(2).into_owned();
        let (turned, place) = match link.joint_type {
            JointType::Revolute => {
                let (r, s) = (pose.rotation, pose.rotation * spin);
                let second = s * spin * (qd[0] * qd[0]) + s * qd[1];
                ([r, s * qd[0], second], fixed(pose.position))
            }
            JointType::Prismatic => (
                [pose.rotation, Matrix3::zeros(), Matrix3::zeros()],
                [pose.position, along * qd[0], along * qd[1]],
            ),
        };
        let rotation = chained(self.rotation, turned);
        let arm = apply(self.rotation, place);
        // What the arm does besides turning with the link before.
        let axis = rotation.map(|r| r.column(2).into_owned());
        let (w, e) = (self.velocity, self.acceleration);
        let fixed_to_link = sum(cross(e, arm), cross(w, cross(w, arm)));
        let carried = sum(self.linear, fixed_to_link);
        let coriolis = cross(w, times(axis, qd));
        let (velocity, acceleration, linear) = match link.joint_type {
            JointType::Revolute => (
                sum(w, times(axis, qd)),
                sum(e, sum(times(axis, qdd), coriolis)),
                carried,
            ),
            JointType::Prismatic => {
                let twice = sum(coriolis, coriolis);
                (w, e, sum(carried, sum(times(axis, qdd), twice)))
            }
        };
        Moving {
            rotation,
            position: sum(self.position, arm),
            velocity,
            acceleration,
            linear,
        }
    }

    /// Newton and Euler for the link at its centre of mass.
    fn loaded(&self, link: &Link) -> Loaded {
        let lever = apply(self.rotation, fixed(link.com));
        let (w, e) = (self.velocity, self.acceleration);
        let of_center = sum(cross(e, lever), cross(w, cross(w, lever)));
        let still = [link.tensor, Matrix3::zeros(), Matrix3::zeros()];
        let transposed = self.rotation.map(|r| r.transpose());
        let tensor = chained(chained(self.rotation, still), transposed);
        Loaded {
            axis: self.rotation.map(|r| r.column(2).into_owned()),
            origin: self.position,
            center: sum(self.position, lever),
            force: sum(self.linear, of_center).map(|a| a * link.mass),
            moment: sum(apply(tensor, e), cross(w, apply(tensor, w))),
        }
    }
}

impl<const N: usize> NewtonEuler<N> {
    /// First and second derivative by time of the torques M qdd + V + G + K + F along a motion. Coulomb
    /// friction counts as constant.
    pub fn inverse_dynamics_rates(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
        jerk: &SVector<f64, N>,
        snap: &SVector<f64, N>,
    ) -> (SVector<f64, N>, SVector<f64, N>) {
        if let Some(coupled) = &self.coupled {
            return coupled.rates([q, qd, qdd], [jerk, snap]);
        }
        let joints = self.joints(q);
        let mut frame = Moving {
            rotation: [Matrix3::identity(), Matrix3::zeros(), Matrix3::zeros()],
            position: REST,
            velocity: REST,
            acceleration: REST,
            linear: minus(fixed(self.gravity)),
        };
        let rows = self.rows();
        let links: [Loaded; N] = core::array::from_fn(|i| {
            if i >= rows {
                return Loaded::NOTHING;
            }
            let (qd, qdd) = ([qd[i], qdd[i], jerk[i]], [qdd[i], jerk[i], snap[i]]);
            frame = frame.next(&self.links[i], &joints[i].pose(), qd, qdd);
            frame.loaded(&self.links[i])
        });
        let torque = |i: usize| {
            if i >= rows {
                return [0.0; 2];
            }
            let joint = &links[i];
            let link = &self.links[i];
            let slope = link.viscous + link.dry.slope(qd[i]);
            let curvature = link.dry.curvature(qd[i]);
            let (inertia, stiffness) = (link.reflected_inertia, link.spring.stiffness);
            let own = [
                inertia * jerk[i] + stiffness * qd[i] + slope * qdd[i],
                inertia * snap[i]
                    + stiffness * qdd[i]
                    + slope * jerk[i]
                    + curvature * qdd[i] * qdd[i],
            ];
            links[i..rows].iter().fold(own, |sum_of, outer| {
                let lever = sum(outer.center, minus(joint.origin));
                let moment = sum(outer.moment, cross(lever, outer.force));
                let felt = match link.joint_type {
                    JointType::Revolute => dot(joint.axis, moment),
                    JointType::Prismatic => dot(joint.axis, outer.force),
                };
                [sum_of[0] + felt[1], sum_of[1] + felt[2]]
            })
        };
        let torques: [[f64; 2]; N] = core::array::from_fn(torque);
        [0, 1]
            .map(|k| SVector::from_fn(|i, _| torques[i][k]))
            .into()
    }
}
