//! The first two derivatives of the joint torques along a motion.
//!
//! Newton-Euler in the base frame, as it stands in textbooks, over jets: of every vector its value and
//! its first two derivatives by time, of every product those by Leibniz's rule.

use core::ops::{Add, Mul};

use dynamics_runtime::internal::geometry::Pose;
use dynamics_runtime::{JointType, Size};
use nalgebra::{Matrix3, Vector3};

use super::base::twist;
use super::inertia::Solid;
use super::link::Link;
use super::walk::Place;
use super::{NumericArm, Placed};

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

/// A force and a moment as they are seen from a frame.
fn seen_from(frame: &FrameJets, wrench: [Vector; 2]) -> [Vector; 2] {
    let transposed = frame.rotation.map(|r| r.transpose());
    wrench.map(|part| apply(transposed, part))
}

/// The sum of two forces and of two moments.
fn added([f, n]: [Vector; 2], [g, m]: [Vector; 2]) -> [Vector; 2] {
    [sum(f, g), sum(n, m)]
}

/// A frame and its motion, in a frame at rest: an arm's base frame, or the place of a base that moves at this moment.
#[derive(Clone, Copy, Debug)]
struct FrameJets {
    rotation: Jet<Matrix3<f64>>,
    position: Vector,
    /// Angular velocity.
    velocity: Vector,
    acceleration: Vector,
    /// Acceleration of the origin, less that of gravity.
    linear: Vector,
}

/// The force and the moment about its centre of mass that the motion of a link takes.
#[derive(Clone, Copy)]
struct Load {
    center: Vector,
    force: Vector,
    moment: Vector,
}

impl Load {
    /// The force, and the moment about a point.
    fn about(&self, point: &Vector) -> [Vector; 2] {
        let lever = sum(self.center, minus(*point));
        [self.force, sum(self.moment, cross(lever, self.force))]
    }
}

impl FrameJets {
    /// A base that stands.
    fn at_rest(gravity: &Vector3<f64>) -> Self {
        FrameJets {
            rotation: [Matrix3::identity(), Matrix3::zeros(), Matrix3::zeros()],
            position: REST,
            velocity: REST,
            acceleration: REST,
            linear: minus(fixed(*gravity)),
        }
    }

    /// A base that moves by this twist, which changes so, in its own axes. Newton and Euler are written down in a frame at rest
    /// that it passes at this moment. Its axes turn against that frame by `R' = R [w]x`.
    fn moving(rates: [[Vector3<f64>; 2]; 4], gravity: &Vector3<f64>) -> Self {
        let part = |k: usize, first: usize| -> Vector {
            core::array::from_fn(|derivative| rates[first + derivative][k])
        };
        let ([linear, linear_rate], [angular, angular_rate]) =
            ([part(0, 0), part(0, 1)], [part(1, 0), part(1, 1)]);
        let (w, wd) = (angular[0].cross_matrix(), angular[1].cross_matrix());
        let rotation = [Matrix3::identity(), w, w * w + wd];
        let velocity = apply(rotation, linear);
        let acceleration = sum(linear_rate, cross(angular, linear));
        FrameJets {
            rotation,
            position: [Vector3::zeros(), velocity[0], velocity[1]],
            velocity: apply(rotation, angular),
            acceleration: apply(rotation, angular_rate),
            linear: sum(apply(rotation, acceleration), minus(fixed(*gravity))),
        }
    }

    /// The frame of the next link: `pose` is where it is in this one, `qd` and `qdd` how it moves.
    fn next(&self, link: &Link, pose: &Pose, qd: Jet<f64>, qdd: Jet<f64>) -> FrameJets {
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
        // The rates of the arm besides turning with the link before.
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
        FrameJets {
            rotation,
            position: sum(self.position, arm),
            velocity,
            acceleration,
            linear,
        }
    }

    /// Newton and Euler for a body at its centre of mass.
    fn load(&self, body: &Solid) -> Load {
        let lever = apply(self.rotation, fixed(body.com));
        let (w, e) = (self.velocity, self.acceleration);
        let of_center = sum(cross(e, lever), cross(w, cross(w, lever)));
        let still = [body.tensor, Matrix3::zeros(), Matrix3::zeros()];
        let transposed = self.rotation.map(|r| r.transpose());
        let tensor = chained(chained(self.rotation, still), transposed);
        Load {
            center: sum(self.position, lever),
            force: sum(self.linear, of_center).map(|a| a * body.mass),
            moment: sum(apply(tensor, e), cross(w, apply(tensor, w))),
        }
    }
}

impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    pub(crate) fn inverse_dynamics_rates(
        &self,
        q: &D::Vector,
        qd: &V::Vector,
        qdd: &V::Vector,
        jerk: &V::Vector,
        snap: &V::Vector,
    ) -> (V::Vector, V::Vector) {
        let rates = [qd, qdd, jerk, snap];
        self.arm.force_rates(q, rates, &self.base.gravity).0
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// The first two derivatives of the forces under a gravity in the axes of the base, and the force and the moment about the
    /// origin of the base that all bodies need, in its axes.
    pub(super) fn force_rates(
        &self,
        q: &D::Vector,
        rates: [&V::Vector; 4],
        gravity: &Vector3<f64>,
    ) -> ((V::Vector, V::Vector), [Vector; 2]) {
        let joints = self.joints(q);
        let base = if self.floats() {
            FrameJets::moving(rates.map(twist), gravity)
        } else {
            FrameJets::at_rest(gravity)
        };
        let mut frames = self.per_link(base);
        self.outward(base, |place, frame| {
            let [v, a, jerk, snap] = rates.map(|rate| place.of(rate));
            let pose = joints[place.k].pose();
            frames[place.k] = frame.next(place.link, &pose, [v, a, jerk], [a, jerk, snap]);
            frames[place.k]
        });
        let mut torques = (self.freedoms.vector(), self.freedoms.vector());
        let mut of_base = [REST; 2];
        let mut add = |place: Place<'_>, [first, second]: [f64; 2]| {
            place.add(&mut torques.0, first);
            place.add(&mut torques.1, second);
        };
        self.walk_outward(|place| {
            let link = place.link;
            let [v, a, jerk, snap] = rates.map(|rate| place.of(rate));
            let slope = link.viscous + link.dry.slope(v);
            let curvature = link.dry.curvature(v);
            let (inertia, stiffness) = (link.reflected_inertia, link.spring.stiffness);
            add(
                place,
                [
                    inertia * jerk + stiffness * v + slope * a,
                    inertia * snap + stiffness * a + slope * jerk + curvature * a * a,
                ],
            );
            let load = frames[place.k].load(&link.solid);
            of_base = added(of_base, load.about(&base.position));
            let Load {
                center,
                force,
                moment,
            } = load;
            self.walk_to_base(place.k, |carrier| {
                let frame = &frames[carrier.k];
                let axis = frame.rotation.map(|r| r.column(2).into_owned());
                let torque = match carrier.link.joint_type {
                    JointType::Revolute => {
                        let lever = sum(center, minus(frame.position));
                        dot(axis, sum(moment, cross(lever, force)))
                    }
                    JointType::Prismatic => dot(axis, force),
                };
                add(carrier, [torque[1], torque[2]]);
            });
        });
        if let Some(body) = self.body() {
            let of_body = base.load(&body.solid).about(&base.position);
            of_base = seen_from(&base, added(of_base, of_body));
            for (i, [_, first, second]) in of_base.into_iter().enumerate() {
                for k in 0..3 {
                    torques.0[3 * i + k] = first[k];
                    torques.1[3 * i + k] = second[k];
                }
            }
        }
        (torques, of_base)
    }
}
