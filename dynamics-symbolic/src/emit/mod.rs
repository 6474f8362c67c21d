//! Emission: programs as Rust methods.
//!
//! Straight-line code, one assignment a line, generic over the runtime's `Scalar`. The same program has the same
//! tokens each time. Other languages (`dynamics-export`) write the same lines: names of variables, the order of inputs,
//! pivots and the lines of documentation are public for them.

mod body;
mod documentation;
mod inputs;
mod inverse;
mod names;
mod parameters;
mod parts;
mod pivots;
mod polynomial;
mod series;
mod signature;

pub use documentation::{
    facts, formula_lines, meanings, quantities, short_formula_lines, unresisted,
};
pub use inputs::{in_order, input_names};
pub use inverse::{description_of_inverse, inverse_kinematics, stub_of_inverse};
pub use names::{field, line_names, shown, visible};
pub use parameters::{BaseParameters, base_parameter_names};
pub use pivots::pivots;
pub use signature::{
    Stubbed, base_parameter_constants, function_type, handed_on, method_name, stub,
    stub_of_function, stub_of_trait,
};
use signature::{
    Types, call, call_of_function, leading_matrix, provided, signature, without_parameters,
};

use crate::formula::Formulas;
use crate::function::{Function, Request};
use crate::program::Proven;
use crate::robot::Robot;
use proc_macro2::TokenStream;
use quote::quote;

/// A method of the struct, and of a trait of the runtime where the function has one.
pub struct Emitted {
    /// The documented item of the inherent implementation.
    pub inherent: TokenStream,
    /// The item of the implementation of the trait that is named as the function is, where the runtime has one.
    pub provided: Option<TokenStream>,
    /// The items of the implementation of the runtime's trait `Function`, where it has no trait of its own.
    pub function: Option<TokenStream>,
}

/// The method `taylor_series`, and the items of `TaylorDynamics`: the inverse dynamics over series, and the mass matrix.
pub fn taylor_series(
    robot: &Robot,
    [equations, matrix]: [&Proven; 2],
    notes: &[String],
    path: &TokenStream,
) -> Emitted {
    let (function, dof) = (Function::TaylorSeries, robot.dof());
    let request = function.into();
    let documentation = documentation::documentation(robot, &request, equations, None, notes);
    let signature = signature(&request, without_parameters(dof), path);
    let call = call(function, dof, path);
    let part = Function::MassMatrix.into();
    let body = body::body(robot, &part, matrix, path);
    let matrix = leading_matrix(dof, path, &body);
    let series = series::items(robot, equations, path);
    Emitted {
        inherent: documented(&documentation, &quote!(#[inline]), &signature, &call),
        provided: Some(quote!(#series #matrix)),
        function: None,
    }
}

/// A method of fewer operations, a sine and its cosine counted as forty, takes less time than a call of it.
const LEAST_CALLED: u32 = 40;

/// The attribute of a method: it is compiled once for each arithmetic, however often it is called.
///
/// rustc writes a short function into its callers, and this one is short: it hands on to a program that is inlined
/// always. With a program at each of some hundred calls the caller takes minutes to compile.
fn inlining(work: u32) -> TokenStream {
    let never = (work >= LEAST_CALLED).then(|| quote!((never)));
    quote!(#[inline #never])
}

/// A public method with its documentation.
fn documented(
    documentation: &[String],
    inlining: &TokenStream,
    signature: &TokenStream,
    body: &TokenStream,
) -> TokenStream {
    let documentation = documentation.iter().map(|line| shown(line));
    quote! {
        #(#[doc = #documentation])*
        #inlining
        #[allow(unused_variables, clippy::all)]
        pub #signature { #body }
    }
}

/// The documented method of a request, which has the number `index` among the methods. `notes` and `formulas` stand in
/// its documentation, `path` is that of the runtime crate.
///
/// The body stands in the implementation of a trait of the runtime, where it is compiled into loops over lanes, for the
/// instructions that are chosen there. The method is a call of it, which is compiled once (`inlining`).
pub fn method(
    robot: &Robot,
    (request, index): (&Request, usize),
    proven: &Proven,
    formulas: Option<&Formulas>,
    notes: &[String],
    path: &TokenStream,
) -> Emitted {
    let documentation = documentation::documentation(robot, request, proven, formulas, notes);
    let sizes = proven.sizes(request, robot.freedoms());
    let signature = signature(request, sizes, path);
    let body = body::body(robot, request, proven, path);
    let work = proven.program.operations().with_sines();
    // The traits of single functions are of robots whose base stands.
    let function = request.function().filter(|_| !sizes.freedoms.has_base());
    let of_trait = function.and_then(|function| {
        let item = provided(function, robot.dof(), path, &body, work)?;
        Some((call(function, robot.dof(), path), item))
    });
    let (call, provided, function) = match of_trait {
        Some((call, item)) => (call, Some(item), None),
        None => {
            let result = quote!(::core::result::Result::Ok({ #body }));
            let body = if request.refuses() { &body } else { &result };
            let items = Types::new(sizes, path).function_items(request, index, body, work);
            let call = call_of_function(request, index, sizes, path);
            (call, None, Some(items))
        }
    };
    Emitted {
        inherent: documented(&documentation, &inlining(work), &signature, &call),
        provided,
        function,
    }
}
