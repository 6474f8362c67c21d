//! Inverse kinematics in closed form: the solutions that a generated `inverse_kinematics` returns, and the equations in one
//! joint of which it is made.

mod angle;
mod real;
mod roots;
mod solutions;

pub use real::Real;
#[doc(hidden)]
pub use roots::{Found, Roots, direction, is_pose, is_reached, slide, slides, turn, turns};
pub(crate) use roots::{is_homogeneous, is_rotation};
#[doc(hidden)]
pub use solutions::Branches;
pub(crate) use solutions::nearest_turn;
pub use solutions::{Solution, Solutions};
