//! Random arms whose joints follow others: their base parameters.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| robot_dynamics_fuzz::couplings(bytes));
