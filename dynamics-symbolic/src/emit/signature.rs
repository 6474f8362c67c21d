//! The signatures of the generated methods.

use super::names::{field, ident, number_of_joints};
use crate::derive::base::observed;
use crate::function::{Argument, Function, Request, Shape, Size, Sizes};
use crate::robot::Robot;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

/// The type of values in an arrangement: `n` is the number of joints as a token.
fn type_of(shape: &Shape, n: &TokenStream, sizes: Sizes, path: &TokenStream) -> TokenStream {
    let size = |size: Size| match size {
        Size::Joints => n.clone(),
        other => Literal::usize_unsuffixed(other.of(sizes)).into_token_stream(),
    };
    match shape {
        Shape::Number => quote!(T),
        Shape::Matrix(Size::Fixed(rows), Size::One) => {
            let vector = ident(&format!("Vector{rows}"));
            quote!(#path::nalgebra::#vector<T>)
        }
        Shape::Matrix(rows, Size::One) => {
            let rows = size(*rows);
            quote!(#path::nalgebra::SVector<T, #rows>)
        }
        Shape::Matrix(Size::Fixed(rows), Size::Fixed(columns)) if rows == columns => {
            let square = ident(&format!("Matrix{rows}"));
            quote!(#path::nalgebra::#square<T>)
        }
        Shape::Matrix(rows, columns) => {
            let (rows, columns) = (size(*rows), size(*columns));
            quote!(#path::nalgebra::SMatrix<T, #rows, #columns>)
        }
        Shape::Each(one) => {
            let one = type_of(one, n, sizes, path);
            quote!([#one; #n])
        }
        Shape::Tuple(parts) => {
            let parts = parts.iter().map(|part| type_of(part, n, sizes, path));
            quote!((#(#parts),*))
        }
        Shape::Series => quote!(#path::TaylorCoefficients<T, #n>),
    }
}

/// The type of what a method returns. The number of joints is none where it could not be told.
fn output_type(
    request: &Request,
    sizes: Sizes,
    n: &TokenStream,
    path: &TokenStream,
) -> TokenStream {
    let of_part = |part: &Function| type_of(part.shape(), n, sizes, path);
    let values = match request {
        Request::One(function) => of_part(function),
        Request::Fused(fused) => {
            let parts = fused.parts.iter().map(of_part);
            quote!((#(#parts),*))
        }
    };
    match request.refuses() {
        true => quote!(::core::result::Result<#values, #path::SingularMassMatrix>),
        false => values,
    }
}

/// The arguments with their types.
fn parameters_of(request: &Request, n: &TokenStream, path: &TokenStream) -> Vec<TokenStream> {
    let none = without_parameters(0);
    let argument = |argument: &Argument| {
        let name = ident(argument.name());
        match argument.shape() {
            Some(shape) => {
                let values = type_of(&shape, n, none, path);
                quote!(#name: &#values)
            }
            None => quote!(#name: usize),
        }
    };
    request.arguments().iter().map(argument).collect()
}

/// The names of the arguments.
fn names(function: Function) -> Vec<Ident> {
    let arguments = function.arguments().iter();
    arguments.map(|argument| ident(argument.name())).collect()
}

/// `fn name<T: Scalar>(&self, q: &SVector<T, N>, ...) -> ...`, without visibility. Without
/// joints, which no robot is, it is generic over their number.
pub(super) fn signature(request: &Request, sizes: Sizes, path: &TokenStream) -> TokenStream {
    let generic = (sizes.joints == 0).then(|| quote!(, const N: usize));
    signature_with(request, sizes, path, generic)
}

fn signature_with(
    request: &Request,
    sizes: Sizes,
    path: &TokenStream,
    generic: Option<TokenStream>,
) -> TokenStream {
    let name = method_name(request);
    let n = number_of_joints(sizes.joints);
    let arguments = parameters_of(request, &n, path);
    let output = output_type(request, sizes, &n, path);
    quote! {
        fn #name<T: #path::Scalar #generic>(&self #(, #arguments)*) -> #output
    }
}

/// The name of a method: that of several functions is the user's.
pub fn method_name(request: &Request) -> Ident {
    match request {
        Request::One(function) => ident(function.name()),
        Request::Fused(fused) => field(&fused.name),
    }
}

/// The sizes of values that are not about base parameters, or whose number could not be told.
pub(super) fn without_parameters(joints: usize) -> Sizes {
    Sizes {
        joints,
        parameters: 0,
    }
}

/// The items of the runtime's trait for the function, if there is one. With `dof` zero the
/// implementation is generic over the number of joints.
pub(super) fn provided(
    function: Function,
    dof: usize,
    path: &TokenStream,
    body: &TokenStream,
    work: u32,
) -> Option<TokenStream> {
    function.trait_name()?;
    if *function.shape() == Shape::Series {
        let series = super::series::declarations([0, 1], 0, dof, path, body);
        let matrix = leading_matrix(dof, path, body);
        return Some(quote!(#series #matrix));
    }
    let (request, sizes) = (Request::One(function), without_parameters(dof));
    let signature = signature_with(&request, sizes, path, None);
    let n = number_of_joints(dof);
    let at = ident(&format!("{}_at", function.name()));
    let sines = ident("sines");
    let (name, names) = (method_name(&request), names(function));
    let arguments = parameters_of(&request, &n, path);
    let output = output_type(&request, sizes, &n, path);
    let work = Literal::u32_unsuffixed(work);
    Some(quote! {
        const WORK: u32 = #work;

        #[inline]
        #signature {
            Self::#name(self #(, #names)*)
        }

        #[inline(always)]
        fn #at<T: #path::Scalar>(
            &self,
            #sines: &impl #path::Inputs<T>
            #(, #arguments)*
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
            #sines: &impl #path::Inputs<T>,
            #q: &#path::nalgebra::SVector<T, #n>
        ) -> #path::nalgebra::SMatrix<T, #n, #n> {
            #body
        }
    }
}

/// The call of the program in the runtime's trait.
pub(super) fn call(function: Function, dof: usize, path: &TokenStream) -> TokenStream {
    let (n, names) = (number_of_joints(dof), names(function));
    let of = ident(function.trait_name().unwrap_or_default());
    if *function.shape() == Shape::Series {
        let name = ident(function.name());
        return quote!(<Self as #path::#of<#n>>::#name(self #(, #names)*));
    }
    let at = ident(&format!("{}_at", function.name()));
    quote!(<Self as #path::#of<#n>>::#at(self, &#path::Evaluated #(, #names)*))
}

/// The associated constants `BASE_PARAMETERS` and `BASE_PARAMETER_NAMES`, where one of the methods
/// is about them: none where an error left their number unknown.
pub fn base_parameter_constants(requests: &[Request], robot: Option<&Robot>) -> TokenStream {
    if !requests.iter().any(Request::is_about_base_parameters) {
        return TokenStream::new();
    }
    let columns = robot.map_or(Vec::new(), observed);
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
pub fn stub(request: &Request, dof: usize, path: &TokenStream) -> TokenStream {
    let signature = signature(request, without_parameters(dof), path);
    let documentation = format!(" `{}`, not generated because of an error.", request.name());
    quote! {
        #[doc = #documentation]
        #[allow(unused_variables)]
        pub #signature { ::core::unimplemented!() }
    }
}

/// The item of the runtime's trait for the function, if there is one, without a body: see
/// [`stub`].
pub fn stub_of_trait(function: Function, dof: usize, path: &TokenStream) -> Option<TokenStream> {
    provided(function, dof, path, &quote!(::core::unimplemented!()), 0)
}

/// The type by which the runtime's trait `Function` knows what is asked for: several functions by their
/// number among the methods.
pub fn function_type(request: &Request, index: usize, path: &TokenStream) -> TokenStream {
    match request {
        Request::One(function) => {
            let name = ident(&format!("{function:?}"));
            quote!(#path::functions::#name)
        }
        Request::Fused(_) => {
            let index = Literal::usize_unsuffixed(index);
            quote!(#path::functions::Fused<#index>)
        }
    }
}

/// Values in an arrangement as the runtime's trait `Arrangement` has them.
fn arrangement(shape: &Shape, n: &TokenStream, sizes: Sizes, path: &TokenStream) -> TokenStream {
    let size = |size: Size| match size {
        Size::Joints => n.clone(),
        other => Literal::usize_unsuffixed(other.of(sizes)).into_token_stream(),
    };
    match shape {
        Shape::Number => quote!(#path::Number),
        Shape::Matrix(rows, columns) => {
            let (rows, columns) = (size(*rows), size(*columns));
            quote!(#path::Entries<#rows, #columns>)
        }
        Shape::Each(one) => {
            let one = arrangement(one, n, sizes, path);
            quote!([#one; #n])
        }
        Shape::Tuple(parts) => {
            let parts = parts.iter().map(|part| arrangement(part, n, sizes, path));
            quote!((#(#parts,)*))
        }
        // It has a trait of its own.
        Shape::Series => quote!(()),
    }
}

/// The items of the runtime's trait `Function` for what has no trait of its own.
pub(super) fn function_items(
    request: &Request,
    index: usize,
    sizes: Sizes,
    path: &TokenStream,
    body: &TokenStream,
    work: u32,
) -> TokenStream {
    let n = number_of_joints(sizes.joints);
    let function = function_type(request, index, path);
    let arguments = request.arguments();
    let shapes = arguments.iter().filter_map(|argument| argument.shape());
    let taken = shapes.map(|shape| arrangement(&shape, &n, sizes, path));
    let parts = request.parts().iter();
    let mut values = parts.map(|part| arrangement(part.shape(), &n, sizes, path));
    let values = match request {
        Request::One(_) => values.next().unwrap_or_default(),
        Request::Fused(_) => quote!((#(#values,)*)),
    };
    let names: Vec<Ident> = arguments
        .iter()
        .map(|argument| ident(argument.name()))
        .collect();
    let texts = arguments.iter().map(|argument| argument.name());
    let (result, work) = (request.result(), Literal::u32_unsuffixed(work));
    let in_lanes = !arguments.is_empty();
    let error = match request.refuses() {
        true => quote!(#path::SingularMassMatrix),
        false => quote!(::core::convert::Infallible),
    };
    let sines = ident("sines");
    quote! {
        type Arguments = (#(#taken,)*);
        type Values = #values;
        type Error = #error;

        const ARGUMENTS: &'static [&'static str] = &[#(#texts),*];
        const RESULT: &'static str = #result;
        const WORK: u32 = #work;
        const IN_LANES: bool = #in_lanes;

        #[inline(always)]
        fn at<T: #path::Scalar>(
            &self,
            _: #function,
            #sines: &impl #path::Inputs<T>,
            (#(#names,)*): &<Self::Arguments as #path::Arrangement>::Of<T>,
        ) -> ::core::result::Result<<Self::Values as #path::Arrangement>::Of<T>, Self::Error> {
            #body
        }
    }
}

/// The call of that.
pub(super) fn call_of_function(
    request: &Request,
    index: usize,
    sizes: Sizes,
    path: &TokenStream,
) -> TokenStream {
    let (n, function) = (
        number_of_joints(sizes.joints),
        function_type(request, index, path),
    );
    let value = match request {
        Request::One(_) => function.clone(),
        Request::Fused(_) => {
            let index = Literal::usize_unsuffixed(index);
            quote!(#path::functions::Fused::<#index>)
        }
    };
    let names = request
        .arguments()
        .into_iter()
        .map(|argument| ident(argument.name()));
    let call = quote! {
        <Self as #path::Function<#function, #n>>::at(self, #value, &#path::Evaluated, &(#(*#names,)*))
    };
    let values = ident("all_values");
    match request.refuses() {
        true => call,
        false => quote!(let ::core::result::Result::Ok(#values) = #call; #values),
    }
}

/// The implementation of the runtime's trait `Function` without a body, where a function has no trait of its own:
/// see [`stub`].
pub fn stub_of_function(
    request: &Request,
    index: usize,
    dof: usize,
    path: &TokenStream,
) -> Option<TokenStream> {
    let body = quote!(::core::unimplemented!());
    let has_trait = request
        .function()
        .is_some_and(|function| function.trait_name().is_some());
    (!has_trait).then(|| function_items(request, index, without_parameters(dof), path, &body, 0))
}

#[cfg(test)]
mod tests {
    use super::Size::{Fixed, Joints, One, Pairs, Parameters};
    use super::*;

    fn written(shape: &Shape) -> String {
        let sizes = Sizes {
            joints: 4,
            parameters: 11,
        };
        let tokens = type_of(shape, &quote!(4), sizes, &quote!(path));
        tokens.to_string().replace("path :: nalgebra :: ", "")
    }

    /// Vectors and matrices in space, of joints, of base parameters, and arrays and tuples of them.
    #[test]
    fn shapes_are_types_of_nalgebra() {
        const OF_SPACE: Shape = Shape::Matrix(Fixed(6), Joints);
        const OF_PARAMETERS: Shape = Shape::Matrix(Parameters, One);
        const SQUARE: Shape = Shape::Matrix(Joints, Joints);
        for (shape, expected) in [
            (Shape::Number, "T"),
            (Shape::Matrix(Joints, One), "SVector < T , 4 >"),
            (Shape::Matrix(Fixed(6), One), "Vector6 < T >"),
            (Shape::Matrix(Fixed(6), Fixed(6)), "Matrix6 < T >"),
            (Shape::Matrix(Fixed(3), Joints), "SMatrix < T , 3 , 4 >"),
            (Shape::Matrix(Joints, Pairs), "SMatrix < T , 4 , 6 >"),
            (Shape::Matrix(Joints, Parameters), "SMatrix < T , 4 , 11 >"),
            (Shape::Each(&OF_SPACE), "[SMatrix < T , 6 , 4 > ; 4]"),
            (
                Shape::Tuple(&[OF_PARAMETERS, OF_PARAMETERS]),
                "(SVector < T , 11 > , SVector < T , 11 >)",
            ),
            (
                Shape::Tuple(&[Shape::Each(&SQUARE), SQUARE]),
                "([SMatrix < T , 4 , 4 > ; 4] , SMatrix < T , 4 , 4 >)",
            ),
        ] {
            assert_eq!(written(&shape), expected);
        }
    }
}
