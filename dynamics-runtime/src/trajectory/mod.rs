//! Trajectories for joints to follow.

mod cycloidal;

pub use cycloidal::{Cycloidal, InvalidDuration};
