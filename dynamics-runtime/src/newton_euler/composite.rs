//! The mass matrix by the composite-rigid-body algorithm, and gravity by composite first moments.
//!
//! Source: R. Featherstone, *Rigid Body Dynamics Algorithms*, Springer 2008, section 6.2.

use core::ops::Add;

use nalgebra::Vector3;

use super::NumericArm;
use super::inertia::{Inertia, Wrench};
use super::joint::Joint;
use crate::JointType;
use crate::size::Size;

impl Inertia {
    /// What gives the body a unit acceleration of its own joint, at rest: with `U = [z]x` and
    /// `a = 0` (revolute) or `U = 0` and `a = z` (prismatic).
    #[inline(always)]
    pub(super) fn unit_wrench(&self, joint_type: JointType) -> Wrench {
        let (h, s) = (&self.first_moment, &self.second_moment);
        match joint_type {
            JointType::Revolute => Wrench {
                force: Vector3::new(-h.y, h.x, 0.0),
                moment: Vector3::new(-s.m13, -s.m23, s.m11 + s.m22),
            },
            JointType::Prismatic => Wrench {
                force: Vector3::new(0.0, 0.0, self.mass),
                moment: Vector3::new(h.y, -h.x, 0.0),
            },
        }
    }
}

impl<D: Size> NumericArm<D> {
    /// M at the joints' positions (Featherstone 2008, table 6.2).
    #[inline(always)]
    pub(super) fn composite_bodies(&self, joints: &D::Links<Joint>) -> D::Matrix {
        let mut composites = self.per_link(Inertia::ZERO);
        for (k, link) in self.links() {
            composites[k] = link.inertia;
        }
        self.inward(&mut composites, |k, body| joints[k].inertia_inward(&body));
        let mut mass_matrix = self.size.matrix();
        for (k, link) in self.links() {
            let mut wrench = composites[k].unit_wrench(link.joint_type);
            let own = wrench.along_joint(link.joint_type) + link.reflected_inertia;
            mass_matrix[(link.joint, link.joint)] += link.factor * link.factor * own;
            let mut from = k;
            for (j, carrier) in self.carriers(k).skip(1) {
                wrench = wrench.inward(&joints[from]);
                from = j;
                let entry = link.factor * carrier.factor * wrench.along_joint(carrier.joint_type);
                mass_matrix[(link.joint, carrier.joint)] += entry;
                mass_matrix[(carrier.joint, link.joint)] += entry;
            }
        }
        mass_matrix
    }

    /// G at the joints' positions: the weight `m g` of all links beyond a joint acts at their
    /// centre of mass, so that joint i carries `-(h x g)_z` (revolute) or `-m g_z` (prismatic).
    #[inline(always)]
    pub(super) fn weights(&self, joints: &D::Links<Joint>) -> D::Vector {
        let gravity = self.outward(self.gravity, |k, _, gravity| joints[k].outward(gravity));
        let mut moments = self.per_link(Moments::NONE);
        for (k, link) in self.links() {
            moments[k] = Moments {
                mass: link.inertia.mass,
                first: link.inertia.first_moment,
            };
        }
        self.inward(&mut moments, |k, Moments { mass, first }| Moments {
            mass,
            first: joints[k].inward(&first) + joints[k].origin * mass,
        });
        let mut torques = self.size.vector();
        for (k, link) in self.links() {
            let (Moments { mass, first: h }, g) = (moments[k], gravity[k]);
            let own = match link.joint_type {
                JointType::Revolute => h.y * g.x - h.x * g.y,
                JointType::Prismatic => -mass * g.z,
            };
            torques[link.joint] += link.factor * own;
        }
        torques
    }
}

/// The mass of bodies, and their first moment about the origin of a frame.
#[derive(Clone, Copy, Debug)]
struct Moments {
    mass: f64,
    first: Vector3<f64>,
}

impl Moments {
    const NONE: Moments = Moments {
        mass: 0.0,
        first: Vector3::new(0.0, 0.0, 0.0),
    };
}

impl Add for Moments {
    type Output = Moments;

    #[inline(always)]
    fn add(self, other: Moments) -> Moments {
        Moments {
            mass: self.mass + other.mass,
            first: self.first + other.first,
        }
    }
}
