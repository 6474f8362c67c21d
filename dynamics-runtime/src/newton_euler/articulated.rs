//! Forward dynamics by articulated bodies: no mass matrix is made, and no factorisation.
//!
//! Source: R. Featherstone, *The calculation of robot dynamics using articulated-body inertias*, Int. J.
//! Robotics Research 2 (1983), 13-30; *Rigid Body Dynamics Algorithms*, Springer 2008, table 7.1,
//! here with accelerations of the frames' origins in place of spatial ones.

use nalgebra::{Matrix3, SVector, Vector3};

use super::NewtonEuler;
use super::inertia::{Inertia, Wrench};
use super::joint::Joint;
use crate::{JointType, SingularMassMatrix};

/// Angular acceleration, and linear acceleration of a frame's origin.
#[derive(Clone, Copy)]
struct Acceleration {
    angular: Vector3<f64>,
    linear: Vector3<f64>,
}

/// The wrench that moves a body whose joints further out are free:
/// `n = A angular + B linear`, `f = B^T angular + D linear`.
#[derive(Clone, Copy)]
struct Articulated {
    a: Matrix3<f64>,
    b: Matrix3<f64>,
    d: Matrix3<f64>,
}

/// What the inward pass leaves for the outward one.
#[derive(Clone, Copy)]
struct Pass {
    /// The joint's acceleration where its link is held.
    free: f64,
    /// The wrench of a unit acceleration of the joint, over the pivot.
    response: Wrench,
}

impl Acceleration {
    /// Of the frame beyond a joint that does not accelerate, at rest.
    fn outward(&self, joint: &Joint) -> Acceleration {
        let linear = self.linear + self.angular.cross(&joint.origin);
        Acceleration {
            angular: joint.outward(&self.angular),
            linear: joint.outward(&linear),
        }
    }

    /// With what the joint adds.
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
    /// Of a rigid body: A = J, B = [h]x, D = m 1.
    fn rigid(inertia: &Inertia) -> Self {
        let s = &inertia.second_moment;
        Articulated {
            a: Matrix3::from_diagonal_element(s.trace()) - s,
            b: inertia.first_moment.cross_matrix(),
            d: Matrix3::from_diagonal_element(inertia.mass),
        }
    }

    /// Of a body to which another one is fixed.
    fn plus(&self, other: &Articulated) -> Self {
        Articulated {
            a: self.a + other.a,
            b: self.b + other.b,
            d: self.d + other.d,
        }
    }

    fn wrench(&self, motion: &Acceleration) -> Wrench {
        Wrench {
            force: self.b.tr_mul(&motion.angular) + self.d * motion.linear,
            moment: self.a * motion.angular + self.b * motion.linear,
        }
    }

    /// The wrench of a unit acceleration of the joint.
    fn unit_wrench(&self, joint_type: JointType) -> Wrench {
        let still = Acceleration {
            angular: Vector3::zeros(),
            linear: Vector3::zeros(),
        };
        self.wrench(&still.plus(joint_type, 1.0))
    }

    /// With the joint free: `I - U U^T / d`, where U is the unit wrench and d the pivot.
    fn freed(&self, u: &Wrench, response: &Wrench) -> Self {
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

impl<const N: usize> NewtonEuler<N> {
    /// Joint accelerations qdd of `M qdd + V + G + K + F = tau`, by articulated bodies: the time grows
    /// with the number of joints, and not with its cube. `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M is not positive definite to working precision, or holds a
    /// NaN.
    pub fn forward_dynamics_aba(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        if self.coupled.is_some() {
            // Articulated bodies are of joints that move by themselves.
            return self.forward_dynamics(q, qd, tau);
        }
        let joints = self.joints(q);
        let (added, needed) = self.velocity_terms(&joints, qd);
        let available = tau - self.joint_forces(q, qd);
        let passes = self.inward_pass(&joints, &added, needed, &available)?;

        let mut qdd = SVector::zeros();
        let mut motion = Acceleration {
            angular: Vector3::zeros(),
            linear: -self.gravity,
        };
        for (i, link) in self.links().iter().enumerate() {
            motion = motion.outward(&joints[i]);
            motion.angular += added[i].angular;
            motion.linear += added[i].linear;
            qdd[i] = passes[i].free - motion.dot(&passes[i].response);
            motion = motion.plus(link.joint_type, qdd[i]);
        }
        Ok(qdd)
    }

    /// What velocities add to each link's acceleration, beside that of the link before it, and the
    /// wrench that each link needs for them: `w x (w x h)` and `w x J w`.
    fn velocity_terms(
        &self,
        joints: &[Joint; N],
        qd: &SVector<f64, N>,
    ) -> ([Acceleration; N], [Wrench; N]) {
        let none = Acceleration {
            angular: Vector3::zeros(),
            linear: Vector3::zeros(),
        };
        let (mut added, mut needed) = ([none; N], [Wrench::ZERO; N]);
        let mut w: Vector3<f64> = Vector3::zeros();
        for (i, link) in self.links().iter().enumerate() {
            let centripetal = w.cross(&w.cross(&joints[i].origin));
            w = joints[i].outward(&w);
            let mut linear = joints[i].outward(&centripetal);
            let rate = Vector3::new(0.0, 0.0, qd[i]);
            let turned = w.cross(&rate);
            match link.joint_type {
                JointType::Revolute => {
                    added[i].angular = turned;
                    w += rate;
                }
                JointType::Prismatic => linear += turned * 2.0,
            }
            added[i].linear = linear;
            let body = Articulated::rigid(&link.inertia);
            needed[i] = Wrench {
                force: w.cross(&w.cross(&link.inertia.first_moment)),
                moment: w.cross(&(body.a * w)),
            };
        }
        (added, needed)
    }

    /// From the tip inwards: the pivots are those of M's factorisation, and so is their scale.
    fn inward_pass(
        &self,
        joints: &[Joint; N],
        added: &[Acceleration; N],
        mut needed: [Wrench; N],
        available: &SVector<f64, N>,
    ) -> Result<[Pass; N], SingularMassMatrix> {
        let none = Pass {
            free: 0.0,
            response: Wrench::ZERO,
        };
        let mut passes = [none; N];
        let mut beyond: Option<Articulated> = None;
        let mut composite = Inertia::ZERO;
        for (i, link) in self.links().iter().enumerate().rev() {
            let rigid = Articulated::rigid(&link.inertia);
            let body = beyond.map_or(rigid, |beyond| rigid.plus(&beyond));
            composite = link.inertia + composite;
            let inertia =
                |wrench: Wrench| wrench.along_joint(link.joint_type) + link.reflected_inertia;
            let unit = body.unit_wrench(link.joint_type);
            let pivot = inertia(unit);
            SingularMassMatrix::test(i, pivot, inertia(composite.unit_wrench(link.joint_type)))?;

            let free = (available[i] - needed[i].along_joint(link.joint_type)) / pivot;
            let response = Wrench {
                force: unit.force / pivot,
                moment: unit.moment / pivot,
            };
            passes[i] = Pass { free, response };
            if i > 0 {
                let freed = body.freed(&unit, &response);
                let moved = freed.wrench(&added[i]);
                let wrench = Wrench {
                    force: needed[i].force + moved.force + unit.force * free,
                    moment: needed[i].moment + moved.moment + unit.moment * free,
                };
                needed[i - 1] = needed[i - 1] + wrench.inward(&joints[i]);
                beyond = Some(freed.inward(&joints[i]));
                composite = joints[i].inertia_inward(&composite);
            }
        }
        Ok(passes)
    }
}
