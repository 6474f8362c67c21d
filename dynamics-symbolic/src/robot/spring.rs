//! Springs at joints.

use super::Value;

/// A linear spring between the link of a joint and the one before it.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring<C = Value> {
    /// Torque or force for each unit of displacement, N m/rad or N/m.
    pub stiffness: C,
    /// The position of the joint at which the spring is slack, rad or m.
    pub rest: C,
}
