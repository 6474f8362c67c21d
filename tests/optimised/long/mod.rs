//! What computes for so long that it is compiled with all optimisation there is:
//! `cargo test --release -p optimised -- --ignored`.

mod energy;
mod sines;
mod stops;
