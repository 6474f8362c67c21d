//! The procedural macro behind `robot_dynamics!`: the library `dynamics-codegen`, called by the
//! compiler.
//!
//! Use it through the crate `robot-dynamics`, whose `robot_dynamics!` hands its tokens
//! on to the macro of this crate, together with the path by which the generated code
//! finds the runtime. Without such a path that is `::dynamics_runtime`.
#![forbid(unsafe_code)]

mod patience;

/// Generates a struct and the equations of motion of a robot arm as its methods, from
/// the arm's Denavit-Hartenberg table. The crate `robot-dynamics` documents the table
/// and the methods.
#[proc_macro]
pub fn robot_dynamics(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    patience::patiently(|say| dynamics_codegen::generate_told(input.into(), say)).into()
}
