//! Every generated function at one state, for the checks.

use dynamics_symbolic::function::{Argument, Part};
use dynamics_symbolic::{Function, Request, method_name};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::target::Target;

/// The methods of `Evaluate`.
pub(super) struct Evaluation {
    /// The body of `evaluate_in`.
    pub(super) functions: TokenStream,
    /// The body of `evaluate_parts`, where a method returns several functions.
    pub(super) parts: Option<TokenStream>,
}

/// The calls of the methods, whose values are kept by the names of the functions.
pub(super) fn evaluation(target: &Target, requests: &[Request]) -> Evaluation {
    let at_state = at_state(target);
    let functions = requests.iter().filter_map(Request::function);
    let values = functions.map(|function| {
        let value = call(&function.into(), &quote!(T));
        set(target, function, &value)
    });
    let values = evaluated(target, &quote!(#(#values)*));
    let fused = requests.iter().filter(|request| request.is_tuple());
    let fused: Vec<_> = fused.map(|request| parts(target, request)).collect();
    Evaluation {
        functions: quote!(#at_state #values),
        parts: (!fused.is_empty()).then(|| quote!(#at_state #(#fused)*)),
    }
}

/// The arguments at the state. Names of variables have a `_` in them: see [`apart`](super::names::apart).
fn at_state(target: &Target) -> TokenStream {
    let path = target.path;
    quote!(let at_state = #path::Arguments::new(state, tau, real);)
}

/// Hands the parts of a method on; where it refuses, each part that is solved for is that refusal.
fn parts(target: &Target, request: &Request) -> TokenStream {
    let name = request.name();
    let call = call(request, &quote!(f64));
    let values: Vec<Ident> = (1..=request.parts().len())
        .map(|number| format_ident!("part_{number}"))
        .collect();
    let of_tip = |part: &Part| part.frame.is_none().then_some(part.function);
    let of_parts = request.parts().iter().zip(&values);
    let of_parts =
        of_parts.filter_map(|(part, value)| Some(set(target, of_tip(part)?, &quote!(#value))));
    let of_parts = quote!(#(#of_parts)*);
    let found = if request.refuses() {
        let of_tip = request.parts().iter().filter_map(of_tip);
        let refused = of_tip.filter(|function| function.row().refuses);
        let error = quote!(::core::result::Result::<f64, _>::Err(x));
        let refused = refused.map(|function| set(target, function, &error));
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
fn set(target: &Target, function: Function, value: &TokenStream) -> TokenStream {
    let (path, name) = (target.path, function.name());
    quote!(#path::Evaluation::set(&mut found_values, #name, #value);)
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
