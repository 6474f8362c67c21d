//! Christoffel symbols of the first kind from composite bodies.
//!
//! With S_j the axis of joint j as a spatial motion vector (w, v), x and x* the
//! spatial cross products (Featherstone 2008, 2.9), and I_m the composite
//! inertia of links m to n, the velocity products of joints j <= k < m act on
//! joint m by D_j . S_k (k outside j), and those of joints j <= m with joint m act on joint
//! i <= m by -D_j . S_i, where
//!
//!   D_j = I_m (S_m x S_j) - S_j x* (I_m S_m) - S_m x* (I_m S_j).

use super::chain::Chain;
use crate::expr::Expr;
use crate::linear::Ring;
use crate::spatial::{Body, Force};

/// The symbols c_ijk, symmetric in j and k, indexed [i][j][k].
pub(super) fn christoffel<'g>(chain: &Chain<Expr<'g>>) -> Vec<Vec<Vec<Expr<'g>>>> {
    let n = chain.links.len();
    let zero = chain.zero;
    let half = zero.graph.half();
    let axes = chain.axes();
    let mut symbols = vec![vec![vec![zero; n]; n]; n];
    chain
        .tree
        .inward(Body::splat(zero), Body::joined, |m, outer| {
            let composite = outer.joined(chain.links[m].body);
            let axis = chain.axis(m);
            let axis_momentum = composite.momentum(axis);
            for &(j, other) in &axes[m] {
                let d = difference(
                    composite.momentum(axis.cross(other)),
                    other.cross_force(axis_momentum),
                    axis.cross_force(composite.momentum(other)),
                );
                for &(i, s) in &axes[m] {
                    let value = half * s.dot(d);
                    symbols[i][j][m] = -value;
                    symbols[i][m][j] = -value;
                    if j <= i && i < m {
                        symbols[m][j][i] = value;
                        symbols[m][i][j] = value;
                    }
                }
            }
            chain.joint(m).leave_body(composite)
        });
    symbols
}

fn difference<R: Ring>(a: Force<R>, b: Force<R>, c: Force<R>) -> Force<R> {
    Force {
        n: a.n - b.n - c.n,
        f: a.f - b.f - c.f,
    }
}
