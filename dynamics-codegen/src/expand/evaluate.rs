//! Every generated function at one state, for the checks.

use dynamics_symbolic::Function;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::Target;

/// The body of `Evaluate::evaluate`.
pub(super) fn evaluation(target: &Target, functions: &[Function]) -> TokenStream {
    let path = target.path;
    // The series has no value at a state.
    let evaluated = functions.iter().filter(|f| **f != Function::TaylorSeries);
    let values = evaluated.map(|function| {
        let name = Ident::new(function.name(), Span::call_site());
        let arguments = arguments(*function);
        let value = quote!(Self::#name(self, #arguments));
        let value = match function {
            // A matrix of as many columns as pairs of joints, a number that the type of the
            // field cannot name.
            Function::CoriolisCoefficients => {
                quote!(#value.column_iter().map(|column| column.into_owned()).collect())
            }
            // So are the number of base parameters, and their type where nothing else says it.
            Function::Regressor => {
                quote!(#value.column_iter().map(|column| column.into_owned()).collect())
            }
            Function::BaseParameters => {
                quote!(Self::base_parameters::<f64>(self).iter().copied().collect())
            }
            _ => value,
        };
        quote!(#name: ::core::option::Option::Some(#value),)
    });
    let coefficients = [
        Function::CoriolisCoefficients,
        Function::CentrifugalCoefficients,
    ];
    let configuration_space = coefficients
        .iter()
        .all(|function| functions.contains(function))
        .then(|| configuration_space(target));
    let regressor_forces = [Function::Regressor, Function::BaseParameters]
        .iter()
        .all(|function| functions.contains(function))
        .then(regressor_forces);
    quote! {
        #path::Evaluation {
            #(#values)*
            #configuration_space
            #regressor_forces
            ..::core::default::Default::default()
        }
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

/// `Y base_parameters`, the joint forces without friction.
fn regressor_forces() -> TokenStream {
    quote! {
        regressor_forces: ::core::option::Option::Some(
            Self::regressor(self, &state.q, &state.qd, &state.qdd) * Self::base_parameters(self)
        ),
    }
}

/// `B [qd qd] + C [qd^2]`, the velocity terms of the configuration-space form (Craig,
/// Introduction to Robotics, 3rd ed., equation 6.63): `[qd qd]` holds the products in
/// the order (1,2), (1,3), ..., (n-1,n).
fn configuration_space(target: &Target) -> TokenStream {
    let path = target.path;
    let n = target.n();
    let pairs = target.dof * target.dof.saturating_sub(1) / 2;
    quote! {
        configuration_space_coriolis: ::core::option::Option::Some({
            let mut products = #path::nalgebra::SVector::<f64, #pairs>::zeros();
            let mut pair = 0;
            for i in 0..#n {
                for j in i + 1..#n {
                    products[pair] = state.qd[i] * state.qd[j];
                    pair += 1;
                }
            }
            let squares = state.qd.component_mul(&state.qd);
            Self::coriolis_coefficients(self, &state.q) * products
                + Self::centrifugal_coefficients(self, &state.q) * squares
        }),
    }
}
