//! The mass matrix by composite bodies (Walker and Orin 1982; Featherstone 2008, 6.2).
//!
//! Column j: the wrench that accelerates the body made of links j to n by a
//! unit acceleration of joint j, carried inwards.

use super::chain::Chain;
use crate::linear::Ring;
use crate::spatial::{Motion, felt_inwards};

/// M(q) by rows, both triangles.
pub(super) fn mass_matrix<R: Ring>(chain: &Chain<R>) -> Vec<Vec<R>> {
    let n = chain.links.len();
    let mut matrix = vec![vec![chain.zero; n]; n];
    let mut composite = chain.links[n - 1].body;
    for (j, link) in chain.links.iter().enumerate().rev() {
        let axis = Motion::axis(link.joint.joint_type, chain.zero, chain.one);
        let column = felt_inwards(composite.momentum(axis), chain.joints().take(j + 1));
        for (i, along) in column.into_iter().enumerate() {
            matrix[i][j] = along;
            matrix[j][i] = along;
        }
        matrix[j][j] = matrix[j][j] + link.reflected;
        if j > 0 {
            composite = link
                .joint
                .leave_body(composite)
                .joined(chain.links[j - 1].body);
        }
    }
    matrix
}
