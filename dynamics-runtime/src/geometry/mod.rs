//! The geometry of a table: sines of constant angles, frames one in the other, joints at a position, inertia tensors.
//!
//! Motions and bodies of links: rows are joined by them when joints are locked, and numeric algorithms are made of them.

mod angle;
mod joint;
mod linear;
mod pose;
mod tensor;

pub use angle::{SinCos, turned};
pub use joint::Joint;
pub use linear::{cross, difference, dot, sum, times};
pub use pose::Pose;
pub use tensor::tensor;
