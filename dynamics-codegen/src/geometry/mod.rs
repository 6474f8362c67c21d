//! Frames and bodies in space: exact where angles are quarter turns, in fifty digits where they are not.

mod number;
mod transform;

pub use number::{direction, number, polar_angle, sin_cos, tidy};
pub use transform::{Body, Mass, Matrix, Transform, Vector, cross, dot};
