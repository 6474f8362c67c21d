//! Items of this project's own crates that follow from the table of functions.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use crate::{Argument, Function, Request, Shape, Size};

/// The types by which the trait `Function` knows the functions, their names, and the trait by which the compiler says
/// what to do about a method that was not requested.
pub fn function_names() -> TokenStream {
    let functions = Function::ALL.into_iter().map(|function| {
        let name = format_ident!("{function:?}");
        let documentation = format!(" `{}`.", function.name());
        let settings = settings(function.arguments());
        let fields = if settings.is_empty() {
            quote!(;)
        } else {
            quote!({ #(#[doc = " As the method has it."] pub #settings: usize),* })
        };
        quote! {
            #[doc = #documentation]
            #[derive(Clone, Copy, Debug)]
            pub struct #name #fields
        }
    });
    let first = Function::ALL.into_iter().filter_map(|function| {
        let name = match function.arguments().first() {
            Some(Argument::Position) => return None,
            Some(argument) => argument.name(),
            None => "parameters",
        };
        let request = Request::from(function);
        let result = request.result();
        Some(quote!(#result => #name,))
    });
    let names = || Function::ALL.into_iter().map(Function::name);
    let hints = names().chain([crate::INVERSE_KINEMATICS]);
    let hints = hints.map(|name| Ident::new(name, Span::call_site()));
    let names = names();
    quote! {
        #(#functions)*

        /// The names of the methods.
        pub const NAMES: &[&str] = &[#(#names),*];

        /// No method of a robot exists that its `functions:` do not name. About `arm.jacobian(&q)` of another one
        /// the compiler says that there is no such method, and that a trait has one of this name: this trait, whose
        /// name says what to do. It is implemented by nothing, so that no method of it is ever offered.
        #[allow(missing_docs)] // The robots' own methods have the documentation.
        pub trait AddItsNameToFunctions {
            #(fn #hints(&self);)*
        }

        /// The argument that says how many states there are, of the function with results of that name, and
        /// of all that take positions.
        pub fn first_argument(result: &str) -> &'static str {
            match result {
                #(#first)*
                "elbow" | "solutions" => "pose",
                _ => "q",
            }
        }
    }
}

/// The methods of a robot at run time: for each function that is a program over numbers one for a state, and one for many.
pub fn runtime_methods() -> TokenStream {
    let is_program = |function: &Function| *function.shape() != Shape::Series;
    let methods = Function::ALL
        .into_iter()
        .filter(is_program)
        .map(|function| {
            let name = function.name();
            let (method, batch) = (format_ident!("{name}"), format_ident!("{name}_batch"));
            let argument = |argument: &Argument| format_ident!("{}", argument.name());
            let arguments: Vec<Ident> = function.arguments().iter().map(argument).collect();
            let value = dynamic_type(function.shape());
            let meaning = format!(" {}", description(function));
            let of_many = format!(" [`{name}`](RuntimeRobot::{name}) at many states.");
            quote! {
                #[doc = #meaning]
                ///
                /// # Errors
                ///
                /// The errors of [`evaluate`](RuntimeRobot::evaluate).
                #[allow(clippy::type_complexity)]
                pub fn #method(&self #(, #arguments: &[f64])*) -> Result<#value, EvaluationError> {
                    self.of_kind(#name, &[#(#arguments),*])
                }

                #[doc = #of_many]
                ///
                /// # Errors
                ///
                /// The errors of [`batch`](RuntimeRobot::batch).
                pub fn #batch(
                    &self,
                    #(#arguments: &[f64],)*
                    results: &mut [f64],
                ) -> Result<(), EvaluationError> {
                    self.batch(#name, &[#(#arguments),*], results)
                }
            }
        });
    quote! {
        /// Every function that is generated has a method of the same name here, for a state, and one for
        /// many: see [`evaluate`](RuntimeRobot::evaluate) and [`batch`](RuntimeRobot::batch), which have
        /// the errors of all of them. `q` in rad or m, rates per second, forces in N m or N.
        impl RuntimeRobot {
            #(#methods)*
        }
    }
}

/// The type of values whose sizes are known at run time.
fn dynamic_type(shape: &Shape) -> TokenStream {
    match shape {
        Shape::Number => quote!(f64),
        Shape::Matrix(_, Size::One) => quote!(DVector<f64>),
        Shape::Matrix(..) => quote!(DMatrix<f64>),
        Shape::Each(_, one) => {
            let one = dynamic_type(one);
            quote!(Vec<#one>)
        }
        Shape::Tuple(parts) => {
            let parts = parts.iter().map(|(_, part)| dynamic_type(part));
            quote!((#(#parts),*))
        }
        Shape::Series => quote!(()),
    }
}

/// The description of a function of any robot.
pub(crate) fn description(function: Function) -> String {
    let description = function.row().description.replace("{frame}", "world");
    description.replace("{tip}", "tip")
}

/// Arguments that are the same for all states.
pub(crate) fn settings(arguments: &[Argument]) -> Vec<Ident> {
    let settings = arguments.iter().filter(|a| a.shape().is_none());
    settings.map(|a| format_ident!("{}", a.name())).collect()
}
