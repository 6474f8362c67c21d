//! States of the arm.

use super::pose::Position;

/// Positions, velocities and accelerations of the joints that move.
pub(super) struct State<R> {
    pub(super) q: Vec<Position<R>>,
    pub(super) qd: Vec<R>,
    pub(super) qdd: Vec<R>,
}
