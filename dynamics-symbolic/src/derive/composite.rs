//! The mass matrix by composite bodies (Walker and Orin 1982; Featherstone 2008, 6.2).
//!
//! Column j: the wrench that accelerates the body made of links j to n by a
//! unit acceleration of joint j, carried inwards.

use super::chain::Chain;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::robot::JointType;

/// M(q) by rows, both triangles.
pub(super) fn mass_matrix<'g>(chain: &Chain<'g>) -> Vec<Vec<Expr<'g>>> {
    let n = chain.links.len();
    let zero = chain.zero;
    let mut matrix = vec![vec![zero; n]; n];
    let mut composite = chain.links[n - 1].body;
    for j in (0..n).rev() {
        let link = &chain.links[j];
        let h = composite.moment;
        let inertia = composite.inertia;
        // f = z x h, n = J z (revolute); f = m z, n = h x z (prismatic).
        let (mut force, mut moment) = match link.joint_type {
            JointType::Revolute => (
                Vector3::new(-h[1], h[0], zero),
                Vector3::new(inertia.xz, inertia.yz, inertia.zz),
            ),
            JointType::Prismatic => (
                Vector3::new(zero, zero, composite.mass),
                Vector3::new(h[1], -h[0], zero),
            ),
        };
        for i in (0..=j).rev() {
            let along = match chain.links[i].joint_type {
                JointType::Revolute => moment[2],
                JointType::Prismatic => force[2],
            };
            matrix[i][j] = along;
            matrix[j][i] = along;
            if i > 0 {
                let link = &chain.links[i];
                force = link.leave(force);
                moment = link.leave(moment) + link.position(zero).cross(force);
            }
        }
        matrix[j][j] = matrix[j][j] + link.reflected;
        if j > 0 {
            composite = link.leave_body(composite).joined(chain.links[j - 1].body);
        }
    }
    matrix
}
