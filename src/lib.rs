#![doc = include_str!("../README.md")]

pub use dynamics_runtime::*;
