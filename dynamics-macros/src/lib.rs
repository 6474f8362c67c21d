//! The procedural macro behind `robot_dynamics!`: the library `dynamics-codegen`, called by the
//! compiler.
//!
//! Use it through the crate `robot-dynamics`, whose `robot_dynamics!` hands its tokens
//! on to the macro of this crate, together with the path by which the generated code
//! finds the runtime. Without such a path that is `::dynamics_runtime`.
#![forbid(unsafe_code)]

#[cfg(feature = "robots")]
mod patience;

/// Generates a struct and the equations of motion of a robot arm as its methods, from
/// the arm's Denavit-Hartenberg table. The crate `robot-dynamics` documents the table
/// and the methods.
#[cfg(feature = "robots")]
#[proc_macro]
pub fn robot_dynamics(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    patience::patiently(|say| dynamics_codegen::generate_told(input.into(), say)).into()
}

/// The types by which the runtime's trait `Function` knows the functions of the engine's table: for the runtime
/// alone.
#[doc(hidden)]
#[proc_macro]
pub fn function_names(_: proc_macro::TokenStream) -> proc_macro::TokenStream {
    dynamics_functions::function_names().into()
}

/// A trait or an implementation with a method for each function that evaluates it at many states: for the
/// runtime alone.
#[doc(hidden)]
#[proc_macro]
pub fn batch_methods(item: proc_macro::TokenStream) -> proc_macro::TokenStream {
    dynamics_functions::batch_methods(item.into()).into()
}

/// The methods of the functions for a robot at run time: for `dynamics-evaluation` alone.
#[doc(hidden)]
#[proc_macro]
pub fn runtime_methods(_: proc_macro::TokenStream) -> proc_macro::TokenStream {
    dynamics_functions::runtime_methods().into()
}
