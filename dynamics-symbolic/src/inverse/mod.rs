//! Inverse kinematics in closed form: joints from the pose of a frame, each from an equation in which it is the only unknown.
//!
//! `search` solves for one joint after the other. An equation is one of those of `rules`, which exist if joint axes meet, are
//! parallel, or are few. Every plan passes a proof before it is used, because its equations are necessary, and need not be
//! sufficient.

mod branch;
mod chain;
mod moves;
mod plan;
mod redundant;
mod rules;
mod search;
mod view;
mod why;

pub use plan::{BranchNames, ELBOW, Plan, Rule, Step, Target};
pub use search::plan;
pub use why::Unsolved;
