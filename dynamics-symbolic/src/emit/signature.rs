//! The signatures of the generated methods.

use crate::derive::base::{Grouping, columns};
use crate::function::Function;
use crate::robot::Robot;
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
        Function::InverseDynamics | Function::InverseDynamicsDerivatives | Function::Regressor => {
            &["q", "qd", "qdd"]
        }
        Function::ForwardDynamics
        | Function::ForwardDynamicsAba
        | Function::ForwardDynamicsDerivatives
        | Function::TaylorSeries => &["q", "qd", "tau"],
        Function::BaseParameters => &[],
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
    /// So many rows, and a column for each base parameter.
    Regressor(usize),
    /// The base parameters, one a row.
    BaseParameters,
    /// Coefficients of Taylor series, or the failure of a pivot.
    TaylorCoefficients,
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
        Function::ForwardDynamics | Function::ForwardDynamicsAba => Shape::Accelerations(dof),
        Function::KineticEnergy | Function::PotentialEnergy => Shape::Number,
        Function::CoriolisCoefficients => Shape::Matrix(dof, dof * (dof.max(1) - 1) / 2),
        Function::ForwardKinematics => Shape::Matrix(4, 4),
        Function::LinkPoses => Shape::Poses(dof),
        Function::Jacobian => Shape::Matrix(6, dof),
        Function::InverseDynamicsDerivatives => Shape::ForceDerivatives(dof),
        Function::ForwardDynamicsDerivatives => Shape::AccelerationDerivatives(dof),
        Function::Regressor => Shape::Regressor(dof),
        Function::BaseParameters => Shape::BaseParameters,
        Function::TaylorSeries => Shape::TaylorCoefficients,
    }
}

fn output_type(
    function: Function,
    dof: usize,
    parameters: usize,
    n: &TokenStream,
    path: &TokenStream,
) -> TokenStream {
    let size = Literal::usize_unsuffixed;
    let square = quote!(#path::nalgebra::SMatrix<T, #n, #n>);
    let parameters = size(parameters);
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
        (Shape::Regressor(_), _) => quote!(#path::nalgebra::SMatrix<T, #n, #parameters>),
        (Shape::TaylorCoefficients, _) => {
            quote!(::core::result::Result<#path::TaylorCoefficients<T, #n>, #path::SingularMassMatrix>)
        }
        (Shape::BaseParameters, _) => quote!(#path::nalgebra::SVector<T, #parameters>),
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
/// `dof` zero, which no robot has, it is generic over the number of joints. `parameters` is the
/// number of base parameters, where the function is about them.
pub(super) fn signature(
    function: Function,
    dof: usize,
    parameters: usize,
    path: &TokenStream,
) -> TokenStream {
    let generic = (dof == 0).then(|| quote!(, const N: usize));
    signature_with(function, dof, parameters, path, generic)
}

fn signature_with(
    function: Function,
    dof: usize,
    parameters: usize,
    path: &TokenStream,
    generic: Option<TokenStream>,
) -> TokenStream {
    let name = ident(function.name());
    let n = number_of_joints(dof);
    let arguments = arguments(function).iter().map(|argument| ident(argument));
    let output = output_type(function, dof, parameters, &n, path);
    let order = (function == Function::TaylorSeries).then(|| {
        let order = ident("order");
        quote!(, #order: usize)
    });
    quote! {
        fn #name<T: #path::Scalar #generic>(
            &self #(, #arguments: &#path::nalgebra::SVector<T, #n>)* #order
        ) -> #output
    }
}

pub(super) fn number_of_joints(dof: usize) -> TokenStream {
    match dof {
        0 => quote!(N),
        _ => Literal::usize_unsuffixed(dof).into_token_stream(),
    }
}

/// The items of the runtime's trait for the function, if there is one. With `dof` zero the
/// implementation is generic over the number of joints.
pub(super) fn provided(
    function: Function,
    dof: usize,
    path: &TokenStream,
    body: &TokenStream,
) -> Option<TokenStream> {
    function.trait_name()?;
    if function == Function::TaylorSeries {
        let series = super::series::declarations([0, 1], dof, path, body);
        let matrix = leading_matrix(dof, path, body);
        return Some(quote!(#series #matrix));
    }
    let signature = signature_with(function, dof, 0, path, None);
    let n = number_of_joints(dof);
    let at = ident(&format!("{}_at", function.name()));
    let sines = ident("sines");
    let arguments: Vec<_> = arguments(function).iter().map(|name| ident(name)).collect();
    let output = output_type(function, dof, 0, &n, path);
    Some(quote! {
        #[inline(always)]
        #signature {
            Self::#at(self, &#path::Evaluated #(, #arguments)*)
        }

        #[inline(always)]
        fn #at<T: #path::Scalar>(
            &self,
            #sines: &impl #path::JointSines<T>
            #(, #arguments: &#path::nalgebra::SVector<T, #n>)*
        ) -> #output {
            #body
        }
    })
}

/// The method of `TaylorDynamics` that is the mass matrix, with a given body.
pub(super) fn leading_matrix(dof: usize, path: &TokenStream, body: &TokenStream) -> TokenStream {
    let n = number_of_joints(dof);
    let [sines, q] = ["sines", "q"].map(ident);
    quote! {
        #[inline(always)]
        fn leading_matrix<T: #path::Scalar>(
            &self,
            #sines: &impl #path::JointSines<T>,
            #q: &#path::nalgebra::SVector<T, #n>
        ) -> #path::nalgebra::SMatrix<T, #n, #n> {
            #body
        }
    }
}

/// The call of the method of the runtime's trait.
pub(super) fn call(function: Function, dof: usize, path: &TokenStream) -> TokenStream {
    let n = number_of_joints(dof);
    let [name, of] = [function.name(), function.trait_name().unwrap_or_default()].map(ident);
    let arguments = arguments(function).iter().map(|argument| ident(argument));
    let order = (function == Function::TaylorSeries).then(|| {
        let order = ident("order");
        quote!(, #order)
    });
    quote!(<Self as #path::#of<#n>>::#name(self #(, #arguments)* #order))
}

/// The associated constants `BASE_PARAMETERS` and `BASE_PARAMETER_NAMES`, where one of the functions
/// is about them: none where an error left their number unknown.
pub fn base_parameter_constants(functions: &[Function], robot: Option<&Robot>) -> TokenStream {
    let of_parameters = [Function::Regressor, Function::BaseParameters];
    if !functions.iter().any(|f| of_parameters.contains(f)) {
        return TokenStream::new();
    }
    let columns = robot.map_or(Vec::new(), |robot| columns(&Grouping::of(robot)));
    let count = Literal::usize_unsuffixed(columns.len());
    let names = columns.iter().map(|&(i, parameter)| parameter.name(i + 1));
    quote! {
        /// Number of base inertial parameters: columns of the regressor.
        pub const BASE_PARAMETERS: usize = #count;

        /// The first term of each base parameter: `J2xx`, `J2xy`, ... of the inertia tensor of link 2,
        /// `h2x`, ... of its first moment, its mass `m2`, the reflected inertia `I2` of its motor. The
        /// documentation of the methods has all terms.
        pub const BASE_PARAMETER_NAMES: [&'static str; #count] = [#(#names),*];
    }
}

/// A method of the right signature without a body: it stands in after an error
/// in the table, so that the rest of the user's file still type-checks. Where
/// the number of joints could not be told, `dof` is zero, and the method takes
/// vectors of any length. There are no base parameters then, whose number could not be told.
pub fn stub(function: Function, dof: usize, path: &TokenStream) -> TokenStream {
    let signature = signature(function, dof, 0, path);
    let documentation = format!(" `{}`, not generated because of an error.", function.name());
    quote! {
        #[doc = #documentation]
        #[allow(unused_variables)]
        pub #signature { ::core::unimplemented!() }
    }
}

/// The item of the runtime's trait for the function, if there is one, without a body: see
/// [`stub`].
pub fn stub_of_trait(function: Function, dof: usize, path: &TokenStream) -> Option<TokenStream> {
    provided(function, dof, path, &quote!(::core::unimplemented!()))
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
