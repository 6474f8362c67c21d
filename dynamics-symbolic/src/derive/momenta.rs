//! Generalized momenta, and the gradient of the kinetic energy, from the links' own.
//!
//! With v_i the velocity of link i as a motion vector and h_i the momentum of links i to n about the
//! origin of frame i, handed on from link to link as forces are, joint i has the momentum
//! (M qd)_i = S_i . h_i. A displacement of joint i adds v_i x S_i to the velocities of the links that it
//! moves, in axes that move with them, so that
//!
//!   dT/dq_i = (v_i x S_i) . h_i,
//!
//! and C' qd, C of the Christoffel symbols, is dT/dq (De Luca, Albu-Schaeffer, Haddadin and Hirzinger
//! 2006: the momentum observer): d/dt (M qd) = tau - G - K - F + C' qd.

use super::chain::Chain;
use crate::linear::Ring;
use crate::spatial::{Force, Motion};

/// M qd
pub(super) fn generalized_momentum<R: Ring>(chain: &Chain<R>, qd: &[R]) -> Vec<R> {
    let momenta = momenta(chain, &velocities(chain, qd));
    let links = chain.links.iter().zip(&momenta).zip(qd);
    let along = links.map(|((link, momentum), &qd)| {
        momentum.along(link.joint.axis_motion) + link.reflected * qd
    });
    along.collect()
}

/// dT/dq
pub(super) fn kinetic_gradient<R: Ring>(chain: &Chain<R>, qd: &[R]) -> Vec<R> {
    let velocities = velocities(chain, qd);
    let momenta = momenta(chain, &velocities);
    let links = velocities.iter().zip(&momenta).enumerate();
    let gradient =
        links.map(|(i, (velocity, momentum))| velocity.cross(chain.axis(i)).dot(*momentum));
    gradient.collect()
}

/// The velocities of all links.
pub(super) fn velocities<R: Ring>(chain: &Chain<R>, qd: &[R]) -> Vec<Motion<R>> {
    let base = Motion::splat(chain.zero);
    chain.tree.outward(base, |i, before| {
        let joint = chain.joint(i);
        before.enter(joint).with_joint(joint.axis_motion, qd[i])
    })
}

/// The momenta of links i to n about the origin of frame i, for every i.
fn momenta<R: Ring>(chain: &Chain<R>, velocities: &[Motion<R>]) -> Vec<Force<R>> {
    let mut momenta = vec![Force::splat(chain.zero); velocities.len()];
    chain.forces_inward(|i, outer| {
        momenta[i] = chain.links[i].body.momentum(velocities[i]) + outer;
        momenta[i]
    });
    momenta
}
