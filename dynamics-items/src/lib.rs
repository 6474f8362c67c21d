//! Items of the runtime and of robots at run time that follow from the table of functions, `dynamics-functions`.
//!
//! They are a crate apart from `robot_dynamics!`: the runtime needs them, and does not wait for the engine.
#![forbid(unsafe_code)]

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
