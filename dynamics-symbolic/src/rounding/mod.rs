//! Counting rounding: a bound on the error of everything that a program computes.
//!
//! A running error analysis: at one point, every operation gives its value in doubles and, from the bounds of its
//! operands, a bound on its own error. The points and the errors that are allowed come from the caller.
//!
//! [`Bounded`] has the rules. [`Running`] applies them to the nodes of a graph, whose definitions may change,
//! [`Rounded`] to finished programs. `outputs_over` bounds them over a box of points, rounded outwards: that is proven.
//! `largest_subdivided` cuts the box where that helps.

mod bounded;
mod constants;
mod over;
mod program;
mod ranged;
mod running;
mod subdivided;
mod walk;

pub use bounded::{Bounded, UNIT};
pub(crate) use over::{outputs_over, ranged};
pub use program::Rounded;
pub(crate) use ranged::{Each, Ranged};
pub use running::{Point, Running};
pub(crate) use subdivided::{Variables, largest_subdivided};

/// At how many points the nodes of a graph are evaluated together.
pub const POINTS: usize = 4;
