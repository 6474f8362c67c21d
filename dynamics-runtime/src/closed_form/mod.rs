//! Inverse kinematics in closed form: the solutions that a generated `inverse_kinematics` returns, and the equations in one
//! joint of which it is made.

mod angle;
mod arc_tangent;
mod elbow;
mod family;
mod follow;
mod pose;
mod real;
mod roots;
mod solutions;

pub use elbow::ElbowRanges;
#[doc(hidden)]
pub use elbow::{elbow_angle, elbow_ranges};
#[doc(hidden)]
pub use family::Family;
pub use follow::BranchEnds;
#[doc(hidden)]
pub use pose::{is_homogeneous, is_rotation, nearest_pose};
pub use real::Real;
#[doc(hidden)]
pub use roots::{Found, Roots, direction, is_reached, slide, slides, turn, turns, turns_of_line};
#[doc(hidden)]
pub use solutions::{Branches, nearest_turn};
pub use solutions::{NoSolution, Solution, Solutions};
