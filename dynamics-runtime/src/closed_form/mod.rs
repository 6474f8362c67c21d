//! Inverse kinematics in closed form: the solutions that a generated `inverse_kinematics` returns, and the equations in one
//! joint of which it is made.

mod real;
mod roots;
mod solutions;

pub use real::Real;
pub use roots::{
    Roots, Slide, Turn, is_reached, slide, slides, turn, turns, turns_at_distance, turns_by,
};
pub use solutions::{Solution, Solutions};
