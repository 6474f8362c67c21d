//! The signatures of the generated methods.

use crate::function::Function;
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

/// The arguments of a function after `&self`, in order.
pub(super) fn arguments(function: Function) -> &'static [&'static str] {
    match function {
        Function::MassMatrix
        | Function::GravityVector
        | Function::PotentialEnergy
        | Function::CoriolisCoefficients
        | Function::CentrifugalCoefficients
        | Function::ForwardKinematics
        | Function::LinkPoses
        | Function::Jacobian => &["q"],
        Function::CoriolisVector
        | Function::KineticEnergy
        | Function::BiasForce
        | Function::CoriolisMatrix => &["q", "qd"],
        Function::FrictionVector => &["qd"],
        Function::InverseDynamics | Function::InverseDynamicsDerivatives => &["q", "qd", "qdd"],
        Function::ForwardDynamics | Function::ForwardDynamicsDerivatives => &["q", "qd", "tau"],
    }
}

/// The arrangement of the outputs: rows and columns of each matrix, and how many matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// One number.
    Number,
    /// A matrix (or vector) of rows and columns.
    Matrix(usize, usize),
    /// Homogeneous transforms in an array.
    Poses(usize),
    /// Accelerations, or the failure of a pivot.
    Accelerations(usize),
    /// Two square matrices: by position, and by velocity.
    ForceDerivatives(usize),
    /// Three square matrices, by position, velocity and force, or the failure of a pivot.
    AccelerationDerivatives(usize),
}

pub(super) fn shape(function: Function, dof: usize) -> Shape {
    match function {
        Function::MassMatrix | Function::CoriolisMatrix | Function::CentrifugalCoefficients => {
            Shape::Matrix(dof, dof)
        }
        Function::CoriolisVector
        | Function::GravityVector
        | Function::FrictionVector
        | Function::InverseDynamics
        | Function::BiasForce => Shape::Matrix(dof, 1),
        Function::ForwardDynamics => Shape::Accelerations(dof),
        Function::KineticEnergy | Function::PotentialEnergy => Shape::Number,
        Function::CoriolisCoefficients => Shape::Matrix(dof, dof * (dof.max(1) - 1) / 2),
        Function::ForwardKinematics => Shape::Matrix(4, 4),
        Function::LinkPoses => Shape::Poses(dof),
        Function::Jacobian => Shape::Matrix(6, dof),
        Function::InverseDynamicsDerivatives => Shape::ForceDerivatives(dof),
        Function::ForwardDynamicsDerivatives => Shape::AccelerationDerivatives(dof),
    }
}

fn output_type(function: Function, dof: usize, n: &TokenStream, path: &TokenStream) -> TokenStream {
    let size = Literal::usize_unsuffixed;
    let square = quote!(#path::nalgebra::SMatrix<T, #n, #n>);
    match (shape(function, dof), function) {
        (Shape::Number, _) => quote!(T),
        (Shape::Poses(_), _) => quote!([#path::nalgebra::Matrix4<T>; #n]),
        (Shape::Accelerations(_), _) => {
            quote!(::core::result::Result<#path::nalgebra::SVector<T, #n>, #path::SingularMassMatrix>)
        }
        (Shape::ForceDerivatives(_), _) => quote!((#square, #square)),
        (Shape::AccelerationDerivatives(_), _) => {
            quote!(::core::result::Result<(#square, #square, #square), #path::SingularMassMatrix>)
        }
        (_, Function::ForwardKinematics) => quote!(#path::nalgebra::Matrix4<T>),
        (_, Function::Jacobian) => quote!(#path::nalgebra::SMatrix<T, 6, #n>),
        (Shape::Matrix(_, columns), Function::CoriolisCoefficients) => {
            let columns = size(columns);
            quote!(#path::nalgebra::SMatrix<T, #n, #columns>)
        }
        (
            _,
            Function::MassMatrix | Function::CoriolisMatrix | Function::CentrifugalCoefficients,
        ) => square,
        (Shape::Matrix(..), _) => quote!(#path::nalgebra::SVector<T, #n>),
    }
}

/// `fn name<T: Scalar>(&self, q: &SVector<T, N>, ...) -> ...`, without visibility. With
/// `dof` zero, which no robot has, it is generic over the number of joints.
pub(super) fn signature(function: Function, dof: usize, path: &TokenStream) -> TokenStream {
    let name = ident(function.name());
    let (generic, n) = match dof {
        0 => (quote!(, const N: usize), quote!(N)),
        _ => (quote!(), Literal::usize_unsuffixed(dof).into_token_stream()),
    };
    let arguments = arguments(function).iter().map(|argument| ident(argument));
    let output = output_type(function, dof, &n, path);
    quote! {
        fn #name<T: #path::Scalar #generic>(&self #(, #arguments: &#path::nalgebra::SVector<T, #n>)*) -> #output
    }
}

/// A method of the right signature without a body: it stands in after an error
/// in the table, so that the rest of the user's file still type-checks. Where
/// the number of joints could not be told, `dof` is zero, and the method takes
/// vectors of any length.
pub fn stub(function: Function, dof: usize, path: &TokenStream) -> TokenStream {
    let signature = signature(function, dof, path);
    let documentation = format!(" `{}`, not generated because of an error.", function.name());
    quote! {
        #[doc = #documentation]
        #[allow(unused_variables)]
        pub #signature { ::core::unimplemented!() }
    }
}

pub(super) fn ident(name: &str) -> proc_macro2::Ident {
    proc_macro2::Ident::new(name, proc_macro2::Span::mixed_site())
}

/// A field's name without the `r#` of a raw identifier.
pub(super) fn plain(field: &str) -> &str {
    field.strip_prefix("r#").unwrap_or(field)
}

/// The identifier of a field of the user's struct.
pub(super) fn field(name: &str) -> proc_macro2::Ident {
    let span = proc_macro2::Span::call_site();
    match name.strip_prefix("r#") {
        Some(raw) => proc_macro2::Ident::new_raw(raw, span),
        None => proc_macro2::Ident::new(name, span),
    }
}
