//! The PUMA 560 and the Panda with pieces left out, and what that costs and does.

#![forbid(unsafe_code)]

pub mod arms;
pub mod features;
pub mod measure;
