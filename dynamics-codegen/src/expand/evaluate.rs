//! Every generated function at one state, for the checks.

use dynamics_symbolic::function::{Argument, Fused, Growth, Shape, Size};
use dynamics_symbolic::{Function, Request, method_name};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::target::Target;

/// The methods of `Evaluate`.
pub(super) struct Evaluation {
    /// The body of `evaluate_in`.
    pub(super) functions: TokenStream,
    /// The body of `evaluate_parts`, where a method returns several functions.
    pub(super) parts: Option<TokenStream>,
}

/// What evaluates the methods.
pub(super) fn evaluation(target: &Target, requests: &[Request]) -> Evaluation {
    let functions = requests.iter().filter_map(Request::function);
    let fields = functions.map(|function| {
        let value = call(target, &Request::One(function), &quote!(T));
        some(function, held(target, function, value))
    });
    let fused = requests.iter().filter_map(|request| match request {
        Request::Fused(fused) => Some(parts(target, request, fused)),
        Request::One(_) => None,
    });
    let fused: Vec<_> = fused.collect();
    Evaluation {
        functions: combined(target, fields),
        parts: (!fused.is_empty()).then(|| quote!(#(#fused)*)),
    }
}

/// Hands the parts of a method on; where it refuses, each part that is solved for is that refusal.
fn parts(target: &Target, request: &Request, fused: &Fused) -> TokenStream {
    let name = request.name();
    let call = call(target, request, &quote!(f64));
    let values: Vec<Ident> = (1..=fused.parts.len())
        .map(|number| Ident::new(&format!("part_{number}"), Span::call_site()))
        .collect();
    let solved = |part: &Function| part.row().refuses;
    let of_parts = fused.parts.iter().zip(&values).map(|(part, value)| {
        let value = held(target, *part, quote!(#value));
        match solved(part) {
            true => some(*part, quote!(::core::result::Result::Ok(#value))),
            false => some(*part, value),
        }
    });
    let of_parts = combined(target, of_parts);
    let of_all = match request.refuses() {
        false => quote!({ let (#(#values),*) = #call; #of_parts }),
        true => {
            let refused = fused.parts.iter().filter(|part| solved(part));
            let refused = refused.map(|part| some(*part, quote!(::core::result::Result::Err(x))));
            let refused = combined(target, refused);
            quote! {
                match #call {
                    ::core::result::Result::Ok((#(#values),*)) => #of_parts,
                    ::core::result::Result::Err(x) => #refused,
                }
            }
        }
    };
    quote!(found_parts(#name, #of_all);)
}

/// An evaluation with these fields and those that follow from them.
fn combined(target: &Target, fields: impl Iterator<Item = TokenStream>) -> TokenStream {
    let (path, qd) = (target.path, at_state(target, Argument::Velocity));
    quote! {
        #path::Evaluation::combined(
            #path::Evaluation {
                #(#fields)*
                ..::core::default::Default::default()
            },
            #qd,
        )
    }
}

/// A field of the evaluation.
fn some(function: Function, value: TokenStream) -> TokenStream {
    let name = Ident::new(function.name(), Span::call_site());
    quote!(#name: ::core::option::Option::Some(#value),)
}

/// The call of a method at the state, in numbers that `real` makes of its doubles.
fn call(target: &Target, request: &Request, number: &TokenStream) -> TokenStream {
    let name = method_name(request);
    let arguments = request.arguments();
    let arguments = arguments.iter().map(|argument| at_state(target, *argument));
    // Without arguments nothing else says the type of the numbers.
    quote!(Self::#name::<#number>(self #(, #arguments)*))
}

/// The value of a function, as the field of that name holds it.
fn held(target: &Target, function: Function, value: TokenStream) -> TokenStream {
    let path = target.path;
    match function.shape() {
        _ if function.row().growth == Growth::Cubic => quote!(#path::boxed(#value)),
        Shape::Matrix(Size::Parameters, Size::One) => {
            quote!(<[_]>::to_vec(#path::nalgebra::Matrix::as_slice(&#value)))
        }
        Shape::Tuple([Shape::Matrix(Size::Parameters, Size::One), ..]) => {
            quote!(#path::vectors(&#value))
        }
        // Numbers of columns that the type of the field cannot name.
        Shape::Matrix(_, Size::Pairs | Size::Parameters) => quote!(#path::columns(&#value)),
        _ => value,
    }
}

/// An argument at the state that is compared. Its methods are called by their paths: behind a point, one of that name of
/// a trait that is in scope around the table could come first.
fn at_state(target: &Target, argument: Argument) -> TokenStream {
    let (path, n) = (target.path, target.n());
    let state = quote!(#path::State::<#n>);
    let vector = match argument {
        Argument::Position => quote!(&state.q),
        Argument::Velocity => quote!(&state.qd),
        Argument::Acceleration => quote!(&state.qdd),
        Argument::Force => quote!(tau),
        Argument::ReferenceVelocity => quote!(&#state::reference_velocity(state)),
        Argument::ReferenceAcceleration => quote!(&#state::reference_acceleration(state)),
        Argument::Jerk => quote!(&#state::jerk(state)),
        Argument::Snap => quote!(&#state::snap(state)),
        Argument::Wrench => quote!(&#state::wrench()),
        Argument::Order => return quote!(#path::Evaluation::<#n>::TAYLOR_ORDER),
    };
    quote!(&#path::nalgebra::Matrix::map(#vector, real))
}
