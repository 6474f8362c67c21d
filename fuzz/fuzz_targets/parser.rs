//! The macro's parser on any text.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| robot_dynamics_fuzz::parser(text));
