//! Inverse kinematics in closed form: the solutions that a generated `inverse_kinematics` returns, and the equations in one
//! joint of which it is made.

mod angle;
mod real;
mod roots;
mod solutions;

pub use real::Real;
#[doc(hidden)]
pub use roots::{
    Found, Roots, direction, inclined_turns, is_reached, root, slide, slides, turn, turns,
    turns_at_distance, turns_by,
};
#[doc(hidden)]
pub use solutions::Branches;
pub use solutions::{Solution, Solutions};
