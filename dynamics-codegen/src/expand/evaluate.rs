//! Every generated function at one state, for the checks.

use dynamics_symbolic::Function;
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
    let (path, n) = (target.path, target.n());
    let name = Ident::new(function.name(), Span::call_site());
    let arguments = arguments(function);
    match function {
        // Matrices of as many columns as pairs of joints, or as base parameters: numbers that the
        // type of the field cannot name.
        Function::CoriolisCoefficients | Function::Regressor => {
            quote!(#path::columns(&Self::#name(self, #arguments)))
        }
        // Nothing else says their type.
        Function::BaseParameters => {
            quote!(<[f64]>::to_vec(Self::#name::<f64>(self).as_slice()))
        }
        Function::TaylorSeries => {
            let order = quote!(#path::Evaluation::<#n>::TAYLOR_ORDER);
            quote!(Self::#name(self, #arguments, #order))
        }
        _ => quote!(Self::#name(self, #arguments)),
    }
}

/// The arguments at a state.
fn arguments(function: Function) -> TokenStream {
    match function {
        Function::MassMatrix
        | Function::GravityVector
        | Function::PotentialEnergy
        | Function::ForwardKinematics
        | Function::LinkPoses
        | Function::Jacobian
        | Function::CoriolisCoefficients
        | Function::CentrifugalCoefficients => quote!(&state.q),
        Function::FrictionVector => quote!(&state.qd),
        Function::CoriolisVector
        | Function::KineticEnergy
        | Function::BiasForce
        | Function::CoriolisMatrix => quote!(&state.q, &state.qd),
        Function::InverseDynamics | Function::InverseDynamicsDerivatives | Function::Regressor => {
            quote!(&state.q, &state.qd, &state.qdd)
        }
        Function::BaseParameters => quote!(),
        Function::ForwardDynamics
        | Function::ForwardDynamicsAba
        | Function::ForwardDynamicsDerivatives
        | Function::TaylorSeries => {
            quote!(&state.q, &state.qd, tau)
        }
    }
}
