//! The equations of motion link by link: see [`Acceleration`].

use super::chain::Chain;
use crate::linear::{Ring, Vector3};
use crate::spatial::{Acceleration, Force, accelerations};

/// Joint forces of a motion: M qdd + V (+ G where `gravity` is the chain's), without springs and friction.
pub(super) fn inverse_dynamics<R: Ring>(
    chain: &Chain<R>,
    qd: &[R],
    qdd: &[R],
    gravity: Vector3<R>,
) -> Vec<R> {
    let base = Acceleration::of_base(chain.zero, gravity);
    let accelerations = accelerations(base, chain.joints(), qd, qdd);
    let links = chain.links.iter().zip(&accelerations);
    let forces = links.map(|(link, acceleration)| acceleration.force(&link.body));
    inward(chain, &forces.collect::<Vec<_>>(), qdd)
}

/// Joint forces from those of the links, from the tip inwards.
pub(super) fn inward<R: Ring>(chain: &Chain<R>, own: &[Force<R>], qdd: &[R]) -> Vec<R> {
    let mut forces = vec![chain.zero; chain.links.len()];
    let mut outer = Force::splat(chain.zero);
    for (i, link) in chain.links.iter().enumerate().rev() {
        let force = own[i] + outer;
        forces[i] = force.along(link.joint.joint_type) + link.reflected * qdd[i];
        outer = force.leave(&link.joint);
    }
    forces
}
