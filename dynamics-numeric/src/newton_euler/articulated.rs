//! Forward dynamics by articulated bodies: no mass matrix is made, and no factorisation.
//!
//! Source: R. Featherstone, *The calculation of robot dynamics using articulated-body inertias*, Int. J.
//! Robotics Research 2 (1983), 13-30; *Rigid Body Dynamics Algorithms*, Springer 2008, table 7.1,
//! here with accelerations of the frames' origins in place of spatial ones.

use core::ops::Add;

use dynamics_runtime::internal::geometry::Joint;
use dynamics_runtime::internal::{factor, substitute};
use dynamics_runtime::{JointType, SingularMassMatrix, Size};
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use super::base::twist;
use super::inertia::{Inertia, Wrench};
use super::walk::Place;
use super::{NumericArm, Placed};

/// Angular acceleration, and linear acceleration of a frame's origin.
#[derive(Clone, Copy, Debug)]
struct Acceleration {
    angular: Vector3<f64>,
    linear: Vector3<f64>,
}

/// The wrench that moves a body whose joints further out are free:
/// `n = A angular + B linear`, `f = B^T angular + D linear`.
#[derive(Clone, Copy, Debug)]
struct Articulated {
    a: Matrix3<f64>,
    b: Matrix3<f64>,
    d: Matrix3<f64>,
}

/// The acceleration that velocities add to that of the link before, and the wrench that the link needs for them:
/// `w x (w x h)` and `w x J w`.
#[derive(Clone, Copy, Debug)]
struct VelocityTerms {
    added: Acceleration,
    needed: Wrench,
}

impl VelocityTerms {
    const REST: VelocityTerms = VelocityTerms {
        added: Acceleration {
            angular: Vector3::new(0.0, 0.0, 0.0),
            linear: Vector3::new(0.0, 0.0, 0.0),
        },
        needed: Wrench::ZERO,
    };
}

/// The results of the inward pass that the outward one reads.
#[derive(Clone, Copy, Debug)]
struct Pass {
    /// The joint's acceleration where its link is held.
    free: f64,
    /// The wrench of a unit acceleration of the joint, over the pivot.
    response: Wrench,
}

/// A link and all beyond it: with the joints further out free, and as one rigid body, and the wrench that it needs.
#[derive(Clone, Copy, Debug)]
struct Beyond {
    body: Articulated,
    composite: Inertia,
    needed: Wrench,
}

impl Add for Beyond {
    type Output = Beyond;

    #[inline(always)]
    fn add(self, other: Beyond) -> Beyond {
        Beyond {
            body: Articulated {
                a: self.body.a + other.body.a,
                b: self.body.b + other.body.b,
                d: self.body.d + other.body.d,
            },
            composite: self.composite + other.composite,
            needed: self.needed + other.needed,
        }
    }
}

impl Beyond {
    /// The body of a base, and the wrench that it needs for its angular velocity.
    fn held(inertia: &Inertia, angular: &Vector3<f64>) -> Beyond {
        let body = Articulated::rigid(inertia);
        Beyond {
            body,
            composite: *inertia,
            needed: Wrench {
                force: angular.cross(&angular.cross(&inertia.first_moment)),
                moment: angular.cross(&(body.a * angular)),
            },
        }
    }

    /// Linear and angular acceleration of a base that carries this, under a force and a moment: those of a body whose joints
    /// are free (Featherstone 2008, table 9.4). Pivots are measured by the entries of the composite body, as those of M are.
    fn free(&self, applied: &Vector6<f64>) -> Result<Vector6<f64>, SingularMassMatrix> {
        let Articulated { a, b, d } = &self.body;
        let mut inertia = Matrix6::zeros();
        inertia.fixed_view_mut::<3, 3>(0, 0).copy_from(d);
        inertia.fixed_view_mut::<3, 3>(3, 0).copy_from(b);
        inertia
            .fixed_view_mut::<3, 3>(0, 3)
            .copy_from(&b.transpose());
        inertia.fixed_view_mut::<3, 3>(3, 3).copy_from(a);
        let mut pivots = self.composite.matrix().diagonal();
        factor(6, &mut inertia, &mut pivots)?;
        let mut acceleration = applied - Vector6::from(self.needed.entries());
        substitute(6, &inertia, &pivots, &mut acceleration);
        Ok(acceleration)
    }
}

impl Acceleration {
    /// The acceleration of the frame beyond a joint that does not accelerate, at rest.
    fn outward(&self, joint: &Joint) -> Acceleration {
        let linear = self.linear + self.angular.cross(&joint.origin);
        Acceleration {
            angular: joint.outward(&self.angular),
            linear: joint.outward(&linear),
        }
    }

    /// The sum with the joint's own acceleration.
    fn plus(self, joint_type: JointType, qdd: f64) -> Acceleration {
        let Acceleration {
            mut angular,
            mut linear,
        } = self;
        match joint_type {
            JointType::Revolute => angular.z += qdd,
            JointType::Prismatic => linear.z += qdd,
        }
        Acceleration { angular, linear }
    }

    /// The power of a wrench on this motion.
    fn dot(&self, wrench: &Wrench) -> f64 {
        self.angular.dot(&wrench.moment) + self.linear.dot(&wrench.force)
    }
}

impl Articulated {
    /// A rigid body: A = J, B = [h]x, D = m 1.
    fn rigid(inertia: &Inertia) -> Self {
        let s = &inertia.second_moment;
        Articulated {
            a: Matrix3::from_diagonal_element(s.trace()) - s,
            b: inertia.first_moment.cross_matrix(),
            d: Matrix3::from_diagonal_element(inertia.mass),
        }
    }

    #[inline(always)]
    fn wrench(&self, motion: &Acceleration) -> Wrench {
        Wrench {
            force: self.b.tr_mul(&motion.angular) + self.d * motion.linear,
            moment: self.a * motion.angular + self.b * motion.linear,
        }
    }

    /// The wrench of a unit acceleration of the joint.
    #[inline(always)]
    fn unit_wrench(&self, joint_type: JointType) -> Wrench {
        let still = Acceleration {
            angular: Vector3::zeros(),
            linear: Vector3::zeros(),
        };
        self.wrench(&still.plus(joint_type, 1.0))
    }

    /// With the joint free: `I - U U^T / d`, where U is the unit wrench and d the pivot.
    fn with_free_joint(&self, u: &Wrench, response: &Wrench) -> Self {
        Articulated {
            a: self.a - u.moment * response.moment.transpose(),
            b: self.b - u.moment * response.force.transpose(),
            d: self.d - u.force * response.force.transpose(),
        }
    }

    /// In the frame before the joint, about its origin p: with A, B, D turned,
    /// `B' = B + [p]x D`, `A' = A - B [p]x + [p]x B'^T`.
    fn inward(&self, joint: &Joint) -> Self {
        let rotation = joint.pose().rotation;
        let [a, b, d] = [self.a, self.b, self.d].map(|x| rotation * x * rotation.transpose());
        let p = joint.origin.cross_matrix();
        let shifted = b + p * d;
        Articulated {
            a: a - b * p + p * shifted.transpose(),
            b: shifted,
            d,
        }
    }
}

impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    pub(crate) fn forward_dynamics_aba(
        &self,
        q: &D::Vector,
        qd: &V::Vector,
        tau: &V::Vector,
    ) -> Result<V::Vector, SingularMassMatrix> {
        let arm = self.arm;
        if arm.count > arm.size.value() {
            // Articulated bodies are of joints that move by themselves.
            return self.forward_dynamics(q, qd, tau);
        }
        let available = tau.clone() - arm.joint_forces(q, qd);
        let accelerations = arm.at(q, |joints| self.articulated_bodies(joints, qd, &available));
        accelerations.map_err(|error| self.named(error))
    }

    /// The accelerations that these forces give the base and the joints where they are so.
    #[inline(always)]
    fn articulated_bodies(
        &self,
        joints: &D::Links<Joint>,
        qd: &V::Vector,
        available: &V::Vector,
    ) -> Result<V::Vector, SingularMassMatrix> {
        let (arm, gravity) = (self.arm, self.base.gravity);
        let Some(body) = arm.body() else {
            let still = Vector3::zeros();
            return arm.accelerations(joints, qd, available, &still, |_| {
                Ok(Acceleration {
                    angular: still,
                    linear: -gravity,
                })
            });
        };
        let [linear, angular] = twist(qd);
        let mut of_base = Vector6::zeros();
        let mut accelerations = arm.accelerations(joints, qd, available, &angular, |links| {
            let own = Beyond::held(&body.solid.inertia, &angular);
            let whole = links.map_or(own, |links| links + own);
            of_base = whole.free(&Vector6::from_fn(|i, _| available[i]))?;
            Ok(Acceleration {
                linear: of_base.fixed_rows::<3>(0).into_owned(),
                angular: of_base.fixed_rows::<3>(3).into_owned(),
            })
        })?;
        // a = dv/dt + w x v - g.
        let apart = gravity - angular.cross(&linear);
        for i in 0..3 {
            accelerations[i] = of_base[i] + apart[i];
            accelerations[3 + i] = of_base[3 + i];
        }
        Ok(accelerations)
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// The accelerations that these torques give the joints, on a base with this angular velocity. `base` is given what the
    /// base carries, if it moves and carries links, and says how it accelerates against gravity.
    #[inline(always)]
    fn accelerations(
        &self,
        joints: &D::Links<Joint>,
        qd: &V::Vector,
        available: &V::Vector,
        angular_velocity: &Vector3<f64>,
        base: impl FnOnce(Option<Beyond>) -> Result<Acceleration, SingularMassMatrix>,
    ) -> Result<V::Vector, SingularMassMatrix> {
        let mut terms = self.per_link(VelocityTerms::REST);
        self.velocity_terms(joints, qd, angular_velocity, &mut terms);
        let mut passes = self.per_link(Pass {
            free: 0.0,
            response: Wrench::ZERO,
        });
        let carried = self.inward_pass(joints, &terms, available, &mut passes)?;

        let mut qdd = self.freedoms.vector();
        self.outward(
            base(carried)?,
            #[inline(always)]
            |Place { k, link, joint, .. }, motion| {
                let mut motion = motion.outward(&joints[k]);
                motion.angular += terms[k].added.angular;
                motion.linear += terms[k].added.linear;
                qdd[joint] = passes[k].free - motion.dot(&passes[k].response);
                motion.plus(link.joint_type, qdd[joint])
            },
        );
        Ok(qdd)
    }

    fn velocity_terms(
        &self,
        joints: &D::Links<Joint>,
        qd: &V::Vector,
        of_base: &Vector3<f64>,
        terms: &mut D::Links<VelocityTerms>,
    ) {
        self.outward(
            *of_base,
            #[inline(always)]
            |place, w| {
                let Place { k, link, .. } = place;
                let centripetal = w.cross(&w.cross(&joints[k].origin));
                let mut w = joints[k].outward(w);
                let mut added = Acceleration {
                    angular: Vector3::zeros(),
                    linear: joints[k].outward(&centripetal),
                };
                let rate = Vector3::new(0.0, 0.0, place.of(qd));
                let turned = w.cross(&rate);
                match link.joint_type {
                    JointType::Revolute => {
                        added.angular = turned;
                        w += rate;
                    }
                    JointType::Prismatic => added.linear += turned * 2.0,
                }
                let body = Articulated::rigid(&link.solid.inertia);
                let needed = Wrench {
                    force: w.cross(&w.cross(&link.solid.inertia.first_moment)),
                    moment: w.cross(&(body.a * w)),
                };
                terms[k] = VelocityTerms { added, needed };
                w
            },
        );
    }

    /// From the tip inwards: the pivots are those of M's factorisation, and so is their scale.
    fn inward_pass(
        &self,
        joints: &D::Links<Joint>,
        terms: &D::Links<VelocityTerms>,
        available: &V::Vector,
        passes: &mut D::Links<Pass>,
    ) -> Result<Option<Beyond>, SingularMassMatrix> {
        let mut singular = Ok(());
        let carried = self.inward(
            #[inline(always)]
            |Place { k, link, .. }| Beyond {
                body: Articulated::rigid(&link.solid.inertia),
                composite: link.solid.inertia,
                needed: terms[k].needed,
            },
            #[inline(always)]
            |place, beyond| {
                let Place { k, link, joint, .. } = place;
                let Beyond {
                    body,
                    composite,
                    needed,
                } = beyond;
                let inertia =
                    |wrench: Wrench| wrench.along_joint(link.joint_type) + link.reflected_inertia;
                let unit = body.unit_wrench(link.joint_type);
                let pivot = inertia(unit);
                let rigid = inertia(composite.unit_wrench(link.joint_type));
                singular = singular.and(SingularMassMatrix::test(joint, pivot, rigid));

                let free = (available[joint] - needed.along_joint(link.joint_type)) / pivot;
                let response = Wrench {
                    force: unit.force / pivot,
                    moment: unit.moment / pivot,
                };
                passes[k] = Pass { free, response };
                place.hand_on(|| {
                    let held = body.with_free_joint(&unit, &response);
                    let moved = held.wrench(&terms[k].added);
                    let needed = Wrench {
                        force: needed.force + moved.force + unit.force * free,
                        moment: needed.moment + moved.moment + unit.moment * free,
                    };
                    Beyond {
                        body: held.inward(&joints[k]),
                        composite: composite.inward(&joints[k]),
                        needed: needed.inward(&joints[k]),
                    }
                })
            },
        );
        singular.map(|()| carried)
    }
}
