//! Programs of the engine in arithmetics that tell their digits: any scalar, 31 digits, and the sizes of
//! what is added. An arm whose functions are evaluated is a `RuntimeRobot` of `dynamics-evaluation`.

#![forbid(unsafe_code)]

mod rounded;

pub use rounded::{AllDigits, At, Inputs, Rounded, is_refused};
