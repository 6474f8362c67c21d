//! The procedural macro behind `robot_dynamics!`.
//!
//! Use it through the crate `robot-dynamics`, whose `robot_dynamics!` hands its tokens
//! on to the macro of this crate, together with the path by which the generated code
//! finds the runtime. Without such a path that is `::dynamics_runtime`.
//!
//! A call passes through these modules:
//!
//! 1. `parse` makes a syntax tree of the tokens, places kept;
//! 2. `validate` makes a `dynamics_symbolic::robot::Robot` of the tree, or reports
//!    every reason why there is none;
//! 3. `dynamics_symbolic` derives the functions and proves them;
//! 4. `expand` writes the struct and its methods. That cannot fail; after an error
//!    it writes the same items with empty methods, so that the code around the call
//!    still passes the type check.
//!
//! `diagnose` collects the errors of a call, which are reported together; `words` finds
//! the word that was meant; `limits` says how much a call may ask for.
#![forbid(unsafe_code)]

extern crate proc_macro;

mod diagnose;
mod expand;
mod limits;
mod parse;
mod syntax;
mod validate;
mod words;

use diagnose::Diagnostics;
use dynamics_symbolic::program::Program;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Method, expand_with};
use proc_macro2::{Span, TokenStream};
use quote::quote;

/// Generates a struct and the equations of motion of a robot arm as its methods, from
/// the arm's Denavit-Hartenberg table. The crate `robot-dynamics` documents the table
/// and the methods.
#[proc_macro]
pub fn robot_dynamics(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    generate(input.into(), &dynamics_symbolic::derive::derive).into()
}

/// Finds the program of a function.
type Derivation = dyn Fn(&Robot, Function) -> Program;

fn generate(input: TokenStream, derivation: &Derivation) -> TokenStream {
    let diagnostics = Diagnostics::new();
    let call = parse::call(input, &diagnostics);
    let generated = validate::model(&call, &diagnostics).and_then(|model| {
        let model = abbreviated(model, &diagnostics)?;
        let methods = methods(&model, &call, derivation, &diagnostics)?;
        Some((model, methods))
    });
    let items = match (&call.structure, &generated) {
        (Some(structure), Some((model, methods))) => {
            expand::robot(structure, model, methods, &call.path)
        }
        (Some(structure), None) => expand::stubs(structure, &call.entries, &call.path),
        (None, _) => TokenStream::new(),
    };
    let errors = diagnostics.into_compile_errors();
    quote!(#errors #items)
}

/// The model without what is to be neglected, or `None` where that is too much: that is reported.
fn abbreviated(mut model: validate::Model, diagnostics: &Diagnostics) -> Option<validate::Model> {
    if let Some((share, place)) = &model.neglect {
        match dynamics_symbolic::neglect::neglect(&model.robot, share.to_f64(&[])) {
            Ok(robot) => model.robot = robot,
            Err(refused) => {
                diagnostics.error(*place, refused);
                return None;
            }
        }
    }
    Some(model)
}

/// The methods, or `None` where the engine could not prove one of them: that is
/// reported at the function's name in the call.
fn methods(
    model: &validate::Model,
    call: &syntax::Call,
    derivation: &Derivation,
    diagnostics: &Diagnostics,
) -> Option<Vec<Method>> {
    let functions: Vec<_> = model.functions.iter().map(|(f, _)| *f).collect();
    let failures = match expand_with(&model.robot, &functions, &call.path, derivation) {
        Ok(methods) => return Some(methods),
        Err(failures) => failures,
    };
    let name = call.structure.as_ref().map(|structure| &structure.name);
    for failure in failures {
        let asked = model
            .functions
            .iter()
            .find(|(f, _)| *f == failure.function());
        let place = asked.and_then(|(_, place)| *place);
        let place = place.or(name.map(Into::into));
        diagnostics.error(place.unwrap_or_else(|| Span::call_site().into()), failure);
    }
    None
}

#[cfg(test)]
mod tests;
