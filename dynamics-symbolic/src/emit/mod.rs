//! Emission: programs as Rust methods.
//!
//! Straight-line code, one assignment a line, generic over the runtime's
//! `Scalar`. Tokens are built by hand where there are many, and are the same
//! for the same program each time.

mod body;
mod documentation;
mod formula;
mod parameters;
mod polynomial;
mod signature;

use signature::signature;
pub use signature::{base_parameter_constants, stub};

use crate::function::Function;
use crate::program::Program;
use crate::robot::Robot;
use proc_macro2::TokenStream;
use quote::quote;

/// The documented method of a function, with the rounded constants of its program; `path` is the
/// path of the runtime crate.
pub fn method(
    robot: &Robot,
    function: Function,
    program: &Program,
    constants: &[f64],
    path: &TokenStream,
) -> TokenStream {
    let documentation = documentation::documentation(robot, function, program, constants);
    let parameters = match function {
        Function::Regressor => program.outputs.len() / robot.rows.len(),
        _ => program.outputs.len(),
    };
    let signature = signature(function, robot.rows.len(), parameters, path);
    let body = body::body(robot, function, program, constants, path);
    quote! {
        #(#[doc = #documentation])*
        #[inline]
        #[allow(unused_variables, clippy::all)]
        pub #signature { #body }
    }
}
