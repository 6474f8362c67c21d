//! The chapters of the guide: `cargo test -p guide --doc` compiles and runs the code of each as one program, which
//! `build.rs` puts together.
#![forbid(unsafe_code)]

// The programs use it.
use robot_dynamics as _;

// Rustdoc reads them where it looks for tests, and nowhere else.
#[cfg(doctest)]
include!(concat!(env!("OUT_DIR"), "/chapters.rs"));
