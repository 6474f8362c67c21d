//! Every generated function at one state, for the checks.

use dynamics_symbolic::function::{Argument, Part, frame_in_methods};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Request, method_name};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::target::Target;

/// The methods of `Evaluate`.
pub(super) struct Evaluation {
    /// The body of `evaluate_in`.
    pub(super) functions: TokenStream,
    /// The body of `evaluate_parts`, where a method returns several functions.
    pub(super) parts: Option<TokenStream>,
}

/// The calls of the methods, whose values are kept by the names of the functions and of their frames.
pub(super) fn evaluation(target: &Target, robot: &Robot, requests: &[Request]) -> Evaluation {
    let at_state = at_state(target);
    let alone = requests.iter().filter(|request| !request.is_tuple());
    let values = alone.map(|request| {
        let value = call(request, &quote!(T));
        set(target, robot, request.parts()[0], &value)
    });
    let values = evaluated(target, &quote!(#(#values)*));
    let fused = requests.iter().filter(|request| request.is_tuple());
    let fused: Vec<_> = fused.map(|request| parts(target, robot, request)).collect();
    Evaluation {
        functions: quote!(#at_state #values),
        parts: (!fused.is_empty()).then(|| quote!(#at_state #(#fused)*)),
    }
}

/// The arguments at the state.
fn at_state(target: &Target) -> TokenStream {
    let path = target.path;
    let arguments = if target.freedoms.has_base() {
        quote!(FloatingArguments)
    } else {
        quote!(Arguments)
    };
    quote!(let at_state = #path::#arguments::new(state, tau, real);)
}

/// Hands the parts of a method on; where it refuses, each part that is solved for is that refusal.
fn parts(target: &Target, robot: &Robot, request: &Request) -> TokenStream {
    let name = request.name();
    let call = call(request, &quote!(f64));
    let values: Vec<Ident> = (1..=request.parts().len())
        .map(|number| format_ident!("part_{number}_"))
        .collect();
    let of_parts = request.parts().iter().zip(&values);
    let of_parts = of_parts.map(|(part, value)| set(target, robot, *part, &quote!(#value)));
    let of_parts = quote!(#(#of_parts)*);
    let found = if request.refuses() {
        let parts = request.parts().iter();
        let refused = parts.filter(|part| part.function.row().refuses);
        let error = quote!(::core::result::Result::<f64, _>::Err(x));
        let refused = refused.map(|part| set(target, robot, *part, &error));
        quote! {
            match #call {
                ::core::result::Result::Ok((#(#values),*)) => { #of_parts }
                ::core::result::Result::Err(x) => { #(#refused)* }
            }
        }
    } else {
        quote!(let (#(#values),*) = #call; #of_parts)
    };
    let found = evaluated(target, &found);
    quote!(found_parts(#name, { #found });)
}

/// The evaluation with these values and the forms that follow from them.
fn evaluated(target: &Target, values: &TokenStream) -> TokenStream {
    let path = target.path;
    quote! {
        let mut found_values: #path::Evaluation<_> = ::core::default::Default::default();
        #values
        #path::Evaluation::combined(found_values, #path::nalgebra::Matrix::as_slice(&at_state.qd))
    }
}

/// Keeps the value of a function. The method is called by its path: behind a point, one of that name of a trait that is in
/// scope around the table could come first.
fn set(target: &Target, robot: &Robot, part: Part, value: &TokenStream) -> TokenStream {
    let (path, name) = (target.path, part.function.name());
    let values = part.frame.map_or(quote!(&mut found_values), |index| {
        let frame = frame_in_methods(&robot.frames[index].name);
        let index = Literal::usize_unsuffixed(index);
        quote!(#path::Evaluation::at_frame(&mut found_values, #frame, #index))
    });
    quote!(#path::Evaluation::set(#values, #name, #value);)
}

/// The call of a method at the state, in numbers of that type: without arguments nothing else says it.
fn call(request: &Request, number: &TokenStream) -> TokenStream {
    let name = method_name(request);
    let arguments = request.arguments().into_iter().map(|argument| {
        let name = Ident::new(argument.name(), Span::call_site());
        match argument {
            Argument::Order => quote!(at_state.#name),
            _ => quote!(&at_state.#name),
        }
    });
    quote!(Self::#name::<#number>(self #(, #arguments)*))
}
