//! The robot and the targets of one search.

use super::InverseKinematics;
use super::normal::Normal;
use super::places::Places;
use super::target::Target;
use crate::size::Size;

/// A search for joint positions at which frames reach these targets.
pub(super) struct Problem<'s, D: Size, P> {
    pub(super) solver: &'s InverseKinematics<D, P>,
    pub(super) targets: &'s [Target],
}

impl<D: Size, P: Places<D>> Problem<'_, D, P> {
    #[inline(always)]
    pub(super) fn normal_at(&self, q: &D::Vector) -> Normal<D> {
        let InverseKinematics {
            places,
            joints,
            tolerance,
            ..
        } = self.solver;
        Normal::at(places, self.targets, joints, tolerance, q)
    }
}
