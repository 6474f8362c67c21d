//! The mass matrix by the composite-rigid-body algorithm, and gravity by composite first moments.
//!
//! Source: R. Featherstone, *Rigid Body Dynamics Algorithms*, Springer 2008, section 6.2.

use nalgebra::{SMatrix, SVector, Vector3};

use super::NewtonEuler;
use super::inertia::{Inertia, Wrench};
use super::joint::Joint;
use crate::JointType;

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

impl<const N: usize> NewtonEuler<N> {
    /// M at the joints' positions (Featherstone 2008, table 6.2).
    #[inline(always)]
    pub(super) fn composite_bodies(&self, joints: &[Joint; N]) -> SMatrix<f64, N, N> {
        let mut mass_matrix = SMatrix::<f64, N, N>::zeros();
        let mut composite = Inertia::ZERO;
        for (i, link) in self.links().iter().enumerate().rev() {
            composite = match joints.get(i + 1) {
                Some(joint) => link.inertia + joint.inertia_inward(&composite),
                None => link.inertia,
            };
            let mut wrench = composite.unit_wrench(link.joint_type);
            mass_matrix[(i, i)] = wrench.along_joint(link.joint_type) + link.reflected_inertia;
            for j in (0..i).rev() {
                wrench = wrench.inward(&joints[j + 1]);
                let entry = wrench.along_joint(self.links[j].joint_type);
                mass_matrix[(i, j)] = entry;
                mass_matrix[(j, i)] = entry;
            }
        }
        mass_matrix
    }

    /// G at the joints' positions: the weight `m g` of all links beyond a joint acts at their
    /// centre of mass, so that joint i carries `-(h x g)_z` (revolute) or `-m g_z` (prismatic).
    #[inline(always)]
    pub(super) fn weights(&self, joints: &[Joint; N]) -> SVector<f64, N> {
        let mut gravity = [Vector3::zeros(); N];
        let mut carried = self.gravity;
        for i in 0..self.rows() {
            carried = joints[i].outward(&carried);
            gravity[i] = carried;
        }

        let mut torques = SVector::zeros();
        let (mut mass, mut first_moment) = (0.0, Vector3::zeros());
        for (i, link) in self.links().iter().enumerate().rev() {
            mass += link.inertia.mass;
            first_moment += link.inertia.first_moment;
            let (h, g): (Vector3<f64>, _) = (first_moment, gravity[i]);
            torques[i] = match link.joint_type {
                JointType::Revolute => h.y * g.x - h.x * g.y,
                JointType::Prismatic => -mass * g.z,
            };
            first_moment = joints[i].inward(&first_moment) + joints[i].origin * mass;
        }
        torques
    }
}
