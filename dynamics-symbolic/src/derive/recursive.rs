//! The equations of motion link by link: see [`Acceleration`](crate::spatial::Acceleration).

use super::chain::Chain;
use crate::linear::{Ring, Vector3};
use crate::spatial::Force;

/// Joint forces of a motion: M qdd + V (+ G where `gravity` is the chain's), without springs and friction.
pub(super) fn inverse_dynamics<R: Ring>(
    chain: &Chain<R>,
    qd: &[R],
    qdd: &[R],
    gravity: Vector3<R>,
) -> Vec<R> {
    let accelerations = chain.accelerations(gravity, qd, qdd);
    let links = chain.links.iter().zip(&accelerations);
    let forces = links.map(|(link, acceleration)| link.writing.force(acceleration, &link.body));
    inward(chain, &forces.collect::<Vec<_>>(), qdd)
}

/// Joint forces from those of the links, from the tips inwards.
pub(super) fn inward<R: Ring>(chain: &Chain<R>, own: &[Force<R>], qdd: &[R]) -> Vec<R> {
    let mut forces = vec![chain.zero; chain.links.len()];
    chain.forces_inward(|i, outer| {
        let (link, force) = (&chain.links[i], own[i] + outer);
        forces[i] = force.along(link.joint.axis_motion) + link.reflected * qdd[i];
        force
    });
    forces
}
