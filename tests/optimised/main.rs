//! Tests that have to be compiled with optimisation, as a controller would be: those that look at the machine code of
//! this program, or measure how long it takes to compile, and those that compute for long.

mod compiled_once;
mod crate_around;
mod long;
mod machine_code;
mod single_precision;
mod three_joints;
mod wide_registers;
