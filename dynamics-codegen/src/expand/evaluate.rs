//! Every generated function at one state, for the checks.

use dynamics_symbolic::Function;
use dynamics_symbolic::function::{Argument, Shape, Size};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::Target;

/// The body of `Evaluate::evaluate`.
pub(super) fn evaluation(target: &Target, functions: &[Function]) -> TokenStream {
    let path = target.path;
    let values = functions.iter().map(|function| {
        let name = Ident::new(function.name(), Span::call_site());
        let value = value(target, *function);
        quote!(#name: ::core::option::Option::Some(#value),)
    });
    quote! {
        #path::Evaluation::combined(
            #path::Evaluation {
                #(#values)*
                ..::core::default::Default::default()
            },
            state,
        )
    }
}

/// The value of a function, as the field of that name holds it.
fn value(target: &Target, function: Function) -> TokenStream {
    let path = target.path;
    let name = Ident::new(function.name(), Span::call_site());
    let arguments = function.arguments().iter();
    let arguments = arguments.map(|argument| at_state(target, *argument));
    // Without arguments nothing else says the type of the numbers.
    let value = quote!(Self::#name::<f64>(self #(, #arguments)*));
    match function.shape() {
        Shape::Matrix(Size::Parameters, Size::One) => quote!(<[f64]>::to_vec(#value.as_slice())),
        // Numbers of columns that the type of the field cannot name.
        Shape::Matrix(_, Size::Pairs | Size::Parameters) => quote!(#path::columns(&#value)),
        _ => value,
    }
}

/// An argument at the state that is compared.
fn at_state(target: &Target, argument: Argument) -> TokenStream {
    let (path, n) = (target.path, target.n());
    match argument {
        Argument::Position => quote!(&state.q),
        Argument::Velocity => quote!(&state.qd),
        Argument::Acceleration => quote!(&state.qdd),
        Argument::Force => quote!(tau),
        Argument::Order => quote!(#path::Evaluation::<#n>::TAYLOR_ORDER),
    }
}
