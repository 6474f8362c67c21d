//! Curves over time as SVG.
//!
//! [`Trajectory::plot`] draws a whole run; a [`Figure`] is made of panels of one's own.

mod figure;
mod run;

use std::error::Error;

#[doc(hidden)]
pub use figure::COLOURS;
pub use figure::{Curve, Figure, joints};

/// The result of drawing: an error where a file cannot be written.
pub type Outcome<T = ()> = Result<T, Box<dyn Error>>;

#[cfg(doc)]
use crate::Trajectory;
