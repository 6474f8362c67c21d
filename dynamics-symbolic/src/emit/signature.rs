//! The signatures of the generated methods.

use super::names::{field, ident, in_tuple, number_of_joints};
use super::parameters::base_parameter_names;
use crate::function::{Argument, Freedoms, Function, Request, Shape, Size, Sizes};
use crate::robot::Robot;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

/// The types of values in generated code: the numbers of joints and of velocities as tokens, the sizes, and the path of
/// the runtime.
pub(super) struct Types<'a> {
    n: TokenStream,
    v: TokenStream,
    sizes: Sizes,
    path: &'a TokenStream,
}

impl<'a> Types<'a> {
    pub(super) fn new(sizes: Sizes, path: &'a TokenStream) -> Self {
        let n = joints(sizes);
        let v = match sizes.freedoms {
            freedoms if freedoms.has_base() => {
                Literal::usize_unsuffixed(freedoms.all()).into_token_stream()
            }
            _ => n.clone(),
        };
        Types { n, v, sizes, path }
    }

    /// The types of a stub.
    fn of_stub(stubbed: Stubbed, path: &'a TokenStream) -> Self {
        let mut types = Types::new(without_parameters(stubbed.freedoms), path);
        if !stubbed.is_known {
            [types.n, types.v] = stubbed.names();
        }
        types
    }

    fn size(&self, size: Size) -> TokenStream {
        match size {
            Size::Joints => self.n.clone(),
            Size::Freedoms => self.v.clone(),
            other => Literal::usize_unsuffixed(other.of(self.sizes)).into_token_stream(),
        }
    }

    /// The type of values in an arrangement.
    fn values(&self, shape: &Shape) -> TokenStream {
        let Types { n, path, .. } = self;
        match shape {
            Shape::Number => quote!(T),
            Shape::Matrix(Size::Fixed(rows), Size::One) => {
                let vector = ident(&format!("Vector{rows}"));
                quote!(#path::nalgebra::#vector<T>)
            }
            Shape::Matrix(rows, Size::One) => {
                let rows = self.size(*rows);
                quote!(#path::nalgebra::SVector<T, #rows>)
            }
            Shape::Matrix(Size::Fixed(rows), Size::Fixed(columns)) if rows == columns => {
                let square = ident(&format!("Matrix{rows}"));
                quote!(#path::nalgebra::#square<T>)
            }
            Shape::Matrix(rows, columns) => {
                let (rows, columns) = (self.size(*rows), self.size(*columns));
                quote!(#path::nalgebra::SMatrix<T, #rows, #columns>)
            }
            Shape::Each(count, one) => {
                let (count, one) = (self.size(*count), self.values(one));
                quote!([#one; #count])
            }
            Shape::Tuple(parts) => {
                let parts = parts.iter().map(|(_, part)| self.values(part));
                quote!((#(#parts),*))
            }
            Shape::Series => quote!(#path::TaylorCoefficients<T, #n>),
        }
    }

    /// An arrangement of values as the runtime's trait `Arrangement` has it.
    fn arrangement(&self, shape: &Shape) -> TokenStream {
        let path = self.path;
        match shape {
            Shape::Number => quote!(#path::Number),
            Shape::Matrix(rows, columns) => {
                let (rows, columns) = (self.size(*rows), self.size(*columns));
                quote!(#path::Entries<#rows, #columns>)
            }
            Shape::Each(count, one) => {
                let (count, one) = (self.size(*count), self.arrangement(one));
                quote!([#one; #count])
            }
            Shape::Tuple(parts) => {
                let parts = parts.iter().map(|(_, part)| self.arrangement(part));
                quote!((#(#parts,)*))
            }
            // It has a trait of its own.
            Shape::Series => quote!(()),
        }
    }

    /// The type of the values that a method returns.
    fn output(&self, request: &Request) -> TokenStream {
        let path = self.path;
        let values = request
            .functions()
            .map(|function| self.values(function.shape()));
        let values = in_tuple(request, values.collect());
        if !request.refuses() {
            return values;
        }
        quote!(::core::result::Result<#values, #path::SingularMassMatrix>)
    }

    /// The arguments with their types.
    fn arguments(&self, request: &Request) -> Vec<TokenStream> {
        let argument = |argument: &Argument| {
            let (name, path) = (ident(argument.name()), self.path);
            if *argument == Argument::Base {
                return quote!(#name: &#path::Pose<T>);
            }
            match argument.shape() {
                Some(shape) => {
                    let values = self.values(&shape);
                    quote!(#name: &#values)
                }
                None => quote!(#name: usize),
            }
        };
        request.arguments().iter().map(argument).collect()
    }

    /// `fn name<T: Scalar>(&self, q: &SVector<T, N>, ...) -> ...`, without visibility.
    fn signature(&self, request: &Request, generic: Option<TokenStream>) -> TokenStream {
        let (name, path) = (method_name(request), self.path);
        let (arguments, output) = (self.arguments(request), self.output(request));
        quote! {
            fn #name<T: #path::Scalar #generic>(&self #(, #arguments)*) -> #output
        }
    }

    /// The items of the runtime's trait `Function` for what has no trait of its own.
    pub(super) fn function_items(
        &self,
        request: &Request,
        index: usize,
        body: &TokenStream,
        work: u32,
    ) -> TokenStream {
        let path = self.path;
        let function = function_type(request, index, path);
        let (arguments, names) = (request.arguments(), names(request));
        let shapes = arguments.iter().filter_map(|argument| argument.shape());
        let taken = shapes.map(|shape| self.arrangement(&shape));
        let arrangements = request
            .functions()
            .map(|function| self.arrangement(function.shape()));
        let values = if request.is_tuple() {
            quote!((#(#arrangements,)*))
        } else {
            arrangements.collect()
        };
        let texts = arguments.iter().map(|argument| argument.name());
        let (result, work) = (request.result(), Literal::u32_unsuffixed(work));
        let has_numbers = |argument: &Argument| {
            argument
                .shape()
                .is_none_or(|shape| shape.entries(self.sizes) > 0)
        };
        let in_lanes = arguments.iter().any(has_numbers);
        let mut error = quote!(::core::convert::Infallible);
        if request.refuses() {
            error = quote!(#path::SingularMassMatrix);
        }
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
}

/// The robot of stubs, which stand in after an error.
#[derive(Clone, Copy)]
pub struct Stubbed {
    /// Its degrees of freedom; no joints where an error left their number unknown.
    pub freedoms: Freedoms,
    /// Whether the number of joints is known.
    pub is_known: bool,
}

impl Stubbed {
    /// The constants that are the unknown numbers of joints and of velocities.
    pub fn names(self) -> [TokenStream; 2] {
        let v = if self.freedoms.has_base() { "V" } else { "N" };
        ["N", v].map(|name| Ident::new(name, Span::call_site()).into_token_stream())
    }

    /// The declaration of these constants, and what is true of them: six velocities more than joints. The compiler finds
    /// either number by the other one.
    pub fn generics(self, path: &TokenStream) -> [TokenStream; 2] {
        if self.is_known {
            return Default::default();
        }
        if !self.freedoms.has_base() {
            return [quote!(const N: usize), TokenStream::new()];
        }
        let nalgebra = quote!(#path::nalgebra);
        [
            quote!(const N: usize, const V: usize),
            quote! {
                where #nalgebra::Const<N>:
                    #nalgebra::DimAdd<#nalgebra::Const<6>, Output = #nalgebra::Const<V>>,
                #nalgebra::Const<V>:
                    #nalgebra::DimSub<#nalgebra::Const<6>, Output = #nalgebra::Const<N>>
            },
        ]
    }
}

/// The number of joints as a token: of an unknown robot, which has no degree of freedom, a constant's name.
fn joints(sizes: Sizes) -> TokenStream {
    if sizes.freedoms.has_base() {
        return Literal::usize_unsuffixed(sizes.freedoms.joints).into_token_stream();
    }
    number_of_joints(sizes.freedoms.joints)
}

/// The names of the arguments.
fn names(request: &Request) -> Vec<Ident> {
    let arguments = request.arguments().into_iter();
    arguments.map(|argument| ident(argument.name())).collect()
}

/// The signature of a method, without visibility.
pub(super) fn signature(request: &Request, sizes: Sizes, path: &TokenStream) -> TokenStream {
    Types::new(sizes, path).signature(request, None)
}

/// The name of a method: that of several functions or of a frame is the user's.
pub fn method_name(request: &Request) -> Ident {
    match request.function() {
        Some(function) => ident(function.name()),
        None => field(request.identifier()),
    }
}

/// The sizes of values that are not about base parameters, or if their number is not known.
pub(super) fn without_parameters(freedoms: impl Into<Freedoms>) -> Sizes {
    Sizes {
        freedoms: freedoms.into(),
        parameters: 0,
    }
}

/// A method of a trait, without its own documentation, that calls the struct's method of the same name.
pub fn handed_on(function: Function, dof: usize, path: &TokenStream) -> TokenStream {
    let request = Request::from(function);
    let signature = Types::new(without_parameters(dof), path).signature(&request, None);
    let (name, names) = (method_name(&request), names(&request));
    quote! {
        #[inline]
        #signature {
            Self::#name(self #(, #names)*)
        }
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
    let request = Request::from(function);
    let types = Types::new(without_parameters(dof), path);
    let (arguments, output) = (types.arguments(&request), types.output(&request));
    let method = handed_on(function, dof, path);
    let [at, sines] = [&format!("{}_at", function.name()), "sines"].map(ident);
    let work = Literal::u32_unsuffixed(work);
    Some(quote! {
        const WORK: u32 = #work;

        #method

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
    let (n, names) = (number_of_joints(dof), names(&function.into()));
    let provided = ident(function.trait_name().unwrap_or_default());
    let name = function.name();
    if *function.shape() == Shape::Series {
        let name = ident(name);
        return quote!(<Self as #path::#provided<#n>>::#name(self #(, #names)*));
    }
    let at = ident(&format!("{name}_at"));
    quote!(<Self as #path::#provided<#n>>::#at(self, &#path::Evaluated #(, #names)*))
}

/// The associated constants `BASE_PARAMETERS` and `BASE_PARAMETER_NAMES`, if one of the methods is about them. Without a
/// robot, because of an error, there are no base parameters.
pub fn base_parameter_constants(requests: &[Request], robot: Option<&Robot>) -> TokenStream {
    if !requests.iter().any(Request::is_about_base_parameters) {
        return TokenStream::new();
    }
    let names = robot.map_or(Vec::new(), base_parameter_names);
    let count = Literal::usize_unsuffixed(names.len());
    quote! {
        /// Number of base inertial parameters: columns of the regressor.
        pub const BASE_PARAMETERS: usize = #count;

        /// The first term of each base parameter: `J2xx`, `J2xy`, ... of the inertia tensor of link 2,
        /// `h2x`, ... of its first moment, its mass `m2`, the reflected inertia `I2` of its motor. The
        /// documentation of the methods has all terms.
        pub const BASE_PARAMETER_NAMES: [&'static str; #count] = [#(#names),*];
    }
}

/// A method of the right signature without a body: it stands in after an error in the table, so that the rest of the
/// user's file still type-checks. If the number of joints is not known, the method takes vectors of any length. The number
/// of base parameters is then 0.
pub fn stub(request: &Request, stubbed: Stubbed, path: &TokenStream) -> TokenStream {
    let [generics, bounds] = stubbed.generics(path);
    let generics = (!stubbed.is_known).then(|| quote!(, #generics));
    let signature = Types::of_stub(stubbed, path).signature(request, generics);
    let documentation = format!(" `{}`, not generated because of an error.", request.name());
    quote! {
        #[doc = #documentation]
        #[allow(unused_variables)]
        pub #signature #bounds { ::core::unimplemented!() }
    }
}

/// The item of the runtime's trait for the function, if there is one, without a body: see [`stub`].
pub fn stub_of_trait(function: Function, dof: usize, path: &TokenStream) -> Option<TokenStream> {
    provided(function, dof, path, &quote!(::core::unimplemented!()), 0)
}

/// The type by which the runtime's trait `Function` knows what is requested: several functions, and a function of a
/// frame, by their number among the methods.
pub fn function_type(request: &Request, index: usize, path: &TokenStream) -> TokenStream {
    match request.function() {
        Some(function) => {
            let name = ident(&format!("{function:?}"));
            quote!(#path::functions::#name)
        }
        None => {
            let index = Literal::usize_unsuffixed(index);
            quote!(#path::functions::Fused<#index>)
        }
    }
}

/// The call of the program in the runtime's trait `Function`.
pub(super) fn call_of_function(
    request: &Request,
    index: usize,
    sizes: Sizes,
    path: &TokenStream,
) -> TokenStream {
    let n = joints(sizes);
    let arguments = request.arguments().into_iter().map(|argument| {
        let name = ident(argument.name());
        match argument {
            Argument::Base => quote!(#path::Pose::entries(#name)),
            _ => quote!(*#name),
        }
    });
    let function = function_type(request, index, path);
    let value = match request.function() {
        Some(_) => function.clone(),
        None => {
            let index = Literal::usize_unsuffixed(index);
            quote!(#path::functions::Fused::<#index>)
        }
    };
    let call = quote! {
        <Self as #path::Function<#function, #n>>::at(self, #value, &#path::Evaluated, &(#(#arguments,)*))
    };
    let values = ident("all_values");
    if request.refuses() {
        return call;
    }
    quote!(let ::core::result::Result::Ok(#values) = #call; #values)
}

/// The implementation of the runtime's trait `Function` without a body, where a function has no trait of its own:
/// see [`stub`].
pub fn stub_of_function(
    request: &Request,
    index: usize,
    stubbed: Stubbed,
    path: &TokenStream,
) -> Option<TokenStream> {
    let body = quote!(::core::unimplemented!());
    let function = request.function();
    let has_trait = match stubbed.freedoms.has_base() {
        true => function.is_some_and(|function| *function.shape() == Shape::Series),
        false => function.and_then(Function::trait_name).is_some(),
    };
    let types = Types::of_stub(stubbed, path);
    (!has_trait).then(|| types.function_items(request, index, &body, 0))
}

#[cfg(test)]
mod tests {
    use super::Size::{Fixed, Freedoms, Joints, One, Pairs, Parameters};
    use super::*;

    fn written(shape: &Shape) -> String {
        let sizes = Sizes {
            freedoms: 4.into(),
            parameters: 11,
        };
        let tokens = Types::new(sizes, &quote!(path)).values(shape);
        tokens.to_string().replace("path :: nalgebra :: ", "")
    }

    /// Vectors and matrices in space, of joints, of base parameters, and arrays and tuples of them.
    #[test]
    fn shapes_are_types_of_nalgebra() {
        const OF_SPACE: Shape = Shape::Matrix(Fixed(6), Freedoms);
        const OF_PARAMETERS: Shape = Shape::Matrix(Parameters, One);
        const SQUARE: Shape = Shape::Matrix(Freedoms, Freedoms);
        for (shape, expected) in [
            (Shape::Number, "T"),
            (Shape::Matrix(Joints, One), "SVector < T , 4 >"),
            (Shape::Matrix(Fixed(6), One), "Vector6 < T >"),
            (Shape::Matrix(Fixed(6), Fixed(6)), "Matrix6 < T >"),
            (Shape::Matrix(Fixed(3), Freedoms), "SMatrix < T , 3 , 4 >"),
            (Shape::Matrix(Joints, Pairs), "SMatrix < T , 4 , 6 >"),
            (Shape::Matrix(Joints, Parameters), "SMatrix < T , 4 , 11 >"),
            (
                Shape::Each(Joints, &OF_SPACE),
                "[SMatrix < T , 6 , 4 > ; 4]",
            ),
            (
                Shape::Tuple(&[("a", OF_PARAMETERS), ("b", OF_PARAMETERS)]),
                "(SVector < T , 11 > , SVector < T , 11 >)",
            ),
            (
                Shape::Tuple(&[("a", Shape::Each(Freedoms, &SQUARE)), ("b", SQUARE)]),
                "([SMatrix < T , 4 , 4 > ; 4] , SMatrix < T , 4 , 4 >)",
            ),
        ] {
            assert_eq!(written(&shape), expected);
        }
    }
}
