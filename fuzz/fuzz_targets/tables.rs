//! Random tables: the engine's programs against the numeric Newton-Euler algorithm.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| robot_dynamics_fuzz::tables(bytes));
