//! Rigid bodies, as a table describes them.

use super::Value;

/// A rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body<C = Value> {
    /// Mass, kg.
    pub mass: C,
    /// Centre of mass in the frame of the body, m.
    pub com: [C; 3],
    /// Inertia tensor about the centre of mass, axes parallel to that frame: entries xx, yy, zz, xy, yz, xz of the
    /// tensor, kg m^2.
    pub inertia: [C; 6],
}

impl Body {
    /// Whether its mass and its tensor are the number zero.
    pub fn is_massless(&self) -> bool {
        self.mass.is_zero() && self.inertia.iter().all(Value::is_zero)
    }
}
