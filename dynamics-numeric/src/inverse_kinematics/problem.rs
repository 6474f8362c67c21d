//! The robot and the targets of one search.

use dynamics_runtime::Size;

use super::InverseKinematics;
use super::joints::Joints;
use super::target::Target;

/// A search for joint positions at which frames reach these targets.
pub(super) struct Problem<'s, D: Size, P> {
    pub(super) solver: &'s InverseKinematics<D, P>,
    /// The joints, with the limits that count.
    pub(super) joints: &'s Joints<D>,
    pub(super) targets: &'s [Target],
}
