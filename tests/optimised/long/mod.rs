//! Tests that compute for so long that they are compiled with all optimisation there is:
//! `cargo test --release -p optimised -- --ignored`.

mod energy;
mod sines;
mod stops;
