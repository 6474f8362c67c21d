//! Friction that falls with the velocity.

use super::Value;

/// Static friction S that falls to Coulomb's C as a joint begins to move:
/// sign(qd) (C + (S - C) exp(-(qd/v)^2)) (Stribeck 1902; in this form Armstrong-Helouvry 1991).
#[derive(Clone, Debug, PartialEq)]
pub struct Stribeck<C = Value> {
    /// S, static friction, the same in both directions, N m (or N).
    pub friction: C,
    /// v, the velocity over which it falls, rad/s (or m/s).
    pub velocity: C,
}
