#![doc = include_str!("../README.md")]
#![cfg_attr(not(feature = "std"), no_std)]
#![forbid(unsafe_code)]

pub use dynamics_runtime::*;

#[cfg(feature = "runtime-robot")]
pub use dynamics_evaluation as evaluation;
