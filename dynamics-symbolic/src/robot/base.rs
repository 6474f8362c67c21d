//! The base of a robot.

use super::{Body, Placement, Value};

/// How frame 0 is in the world.
#[derive(Clone, Debug, PartialEq)]
pub enum Base<C = Value> {
    /// It stands there.
    Standing(Placement<C>),
    /// It moves freely with this body, which is described in frame 0. A velocity, an acceleration or a force then begins
    /// with six numbers in the axes of frame 0: the linear one of its origin, then the angular one.
    Floating(Body<C>),
}

impl Base {
    /// The degrees of freedom of a base that moves.
    pub const FREEDOMS: usize = 6;
}
