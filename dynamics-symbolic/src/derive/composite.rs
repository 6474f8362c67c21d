//! The mass matrix by composite bodies (Walker and Orin 1982; Featherstone 2008, 6.2).
//!
//! Column j: the wrench that accelerates the body made of links j to n by a
//! unit acceleration of joint j, carried inwards.
//!
//! Gravity is an acceleration -g of the base. What joint j feels of that is, for M is symmetric, what the
//! base feels along -g of a unit acceleration of joint j: G_j = -g.f_j with the force of column j.

use super::chain::Chain;
use crate::linear::Ring;
use crate::spatial::{Body, Force, Motion, felt_inwards};

/// M(q) by rows, both triangles.
pub(super) fn mass_matrix<R: Ring>(chain: &Chain<R>) -> Vec<Vec<R>> {
    let n = chain.links.len();
    let mut matrix = vec![vec![chain.zero; n]; n];
    for (j, composite) in composites(chain) {
        let column = felt_inwards(wrench(chain, j, &composite), chain.joints().take(j + 1));
        for (i, along) in column.into_iter().enumerate() {
            matrix[i][j] = along;
            matrix[j][i] = along;
        }
        matrix[j][j] = matrix[j][j] + chain.links[j].reflected;
    }
    matrix
}

/// G(q) from the forces of M's columns.
pub(super) fn gravity_vector<R: Ring>(chain: &Chain<R>) -> Vec<R> {
    let g = chain.links[0].joint.enter(chain.gravity);
    let felt = composites(chain).map(|(j, composite)| {
        let inwards = chain.links[1..=j].iter().rev();
        let on_first = inwards.fold(wrench(chain, j, &composite), |force, link| {
            force.leave(&link.joint)
        });
        -g.dot(on_first.f)
    });
    let mut felt: Vec<R> = felt.collect();
    felt.reverse();
    felt
}

/// From the tip inwards, each link with all links outside it as one body.
fn composites<R: Ring>(chain: &Chain<R>) -> impl Iterator<Item = (usize, Body<R>)> {
    let mut outer: Option<Body<R>> = None;
    (0..chain.links.len()).rev().map(move |j| {
        let own = chain.links[j].body;
        let composite = outer.map_or(own, |outer| {
            chain.links[j + 1].joint.leave_body(outer).joined(own)
        });
        outer = Some(composite);
        (j, composite)
    })
}

/// What a unit acceleration of joint j takes.
fn wrench<R: Ring>(chain: &Chain<R>, j: usize, composite: &Body<R>) -> Force<R> {
    let joint_type = chain.links[j].joint.joint_type;
    composite.momentum(Motion::axis(joint_type, chain.zero, chain.one))
}
