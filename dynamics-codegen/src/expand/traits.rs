//! The runtime's traits: those of single functions hold the programs, the methods of the others
//! hand on to the struct's own.

use dynamics_symbolic::emit::field;
use dynamics_symbolic::{Function, Request, function_type, handed_on};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

use super::batch;
use super::evaluate::Evaluation;
use super::target::Target;

/// The impls of all traits that the functions allow for. `angles` says of each joint whether a
/// function of a [`provided`] trait reads its sine; `table` is the body of the method of that
/// name.
pub(super) fn traits(
    target: &Target,
    functions: &[Function],
    angles: &[bool],
    table: &TokenStream,
    evaluation: &Evaluation,
) -> TokenStream {
    // These traits are of robots whose base stands.
    let has = |function| functions.contains(&function) && !target.freedoms.has_base();
    let of_energies = [Function::KineticEnergy, Function::PotentialEnergy];
    let has_energies = of_energies.iter().all(|energy| functions.contains(energy));
    let model = model(target, angles, table, has_energies);
    let evaluate = evaluate(target, evaluation);
    let pairs = [
        (
            "Energy",
            [Function::KineticEnergy, Function::PotentialEnergy],
        ),
        (
            "Kinematics",
            [Function::ForwardKinematics, Function::Jacobian],
        ),
    ];
    let pairs = pairs
        .iter()
        .filter(|(_, pair)| pair.iter().all(|function| has(*function)));
    let pairs = pairs.map(|(name, pair)| {
        let (header, _) = header(target, ident(name));
        let methods = pair.map(|function| handed_on(function, target.freedoms.joints, target.path));
        quote!(#header { #(#methods)* })
    });
    let articulated = (has(Function::ForwardDynamicsAba) && !has(Function::ForwardDynamics))
        .then(|| articulated_dynamics(target));
    quote!(#model #evaluate #(#pairs)* #articulated)
}

fn ident(name: &str) -> TokenStream {
    Ident::new(name, Span::call_site()).into_token_stream()
}

/// The traits of single functions, whose methods hold the programs.
pub(super) fn provided(
    target: &Target,
    items: impl Iterator<Item = (Function, TokenStream)>,
) -> TokenStream {
    let implementation = |(function, item): (Function, TokenStream)| {
        let (header, _) = header(target, ident(function.trait_name()?));
        Some(quote!(#header { #item }))
    };
    items.filter_map(implementation).collect()
}

/// The implementations of the trait `Function` of what has no trait of its own, in the order of the methods.
pub(super) fn functions<'a>(
    target: &Target,
    items: impl Iterator<Item = (&'a Request, Option<TokenStream>)>,
) -> TokenStream {
    let [n, _] = target.sizes();
    let implementation = |(index, (request, items)): (usize, (&Request, Option<TokenStream>))| {
        let items = items?;
        let function = function_type(request, index, target.path);
        let start = of_all(target, quote!(Function<#function, #n>));
        Some(quote!(#start { #items }))
    };
    items.enumerate().filter_map(implementation).collect()
}

/// The value of the field of the number `index`, where there are some.
pub(super) fn field_by_index(fields: &[String]) -> Option<TokenStream> {
    if fields.is_empty() {
        return None;
    }
    let arms = fields.iter().enumerate().map(|(i, name)| {
        let (i, name) = (Literal::usize_unsuffixed(i), field(name));
        quote!(#i => self.#name,)
    });
    Some(quote! {
        match index {
            #(#arms)*
            _ => 0.0,
        }
    })
}

/// The trait that reads the field of the number `index`, beside the batches that belong to the robot.
pub(super) fn fields(target: &Target, value: &TokenStream, requests: &[Request]) -> TokenStream {
    let path = target.path;
    let start = start(target, [quote!(), quote!()], quote!(Fields));
    let fields = |of_each: TokenStream| {
        quote! {
            #path::__with_std! {
                #start {
                    type OfEach<'a> = #of_each;

                    #[inline(always)]
                    fn field(&self, index: usize) -> f64 {
                        #value
                    }
                }
            }
        }
    };
    let of_each = batch::type_of_each(target.name);
    let with_own = batch::of_each(target, requests, &fields(quote!(#of_each<'a>)));
    with_own.unwrap_or_else(|| fields(quote!(#path::WithParameters<'a, Self>)))
}

/// The method by which structure-preserving integration asks an arm with forward dynamics for momenta, where there are
/// the functions that it takes.
pub(super) fn momenta(target: &Target, functions: &[Function]) -> Option<TokenStream> {
    let (path, n) = (target.path, target.n());
    let needed = [Function::MassMatrix, Function::InverseDynamics];
    needed.iter().all(|f| functions.contains(f)).then(|| {
        quote! {
            #[inline]
            fn momenta(&self) -> ::core::option::Option<&dyn #path::Momenta<#n>> {
                ::core::option::Option::Some(self)
            }
        }
    })
}

/// The start of an impl of a trait of robots whose base stands, and the number of joints in it.
fn header(target: &Target, name: TokenStream) -> (TokenStream, TokenStream) {
    let [n, _] = target.sizes();
    (of_all(target, quote!(#name<#n>)), n)
}

/// The start of an impl. Where an error left the number of joints unknown it is for all of them.
fn of_all(target: &Target, name: TokenStream) -> TokenStream {
    start(target, target.stubbed().generics(target.path), name)
}

fn start(target: &Target, [generics, bounds]: [TokenStream; 2], name: TokenStream) -> TokenStream {
    let Target {
        name: structure,
        cfgs,
        path,
        ..
    } = target;
    let generics = (!generics.is_empty()).then(|| quote!(<#generics>));
    quote! {
        #cfgs
        #[automatically_derived]
        #[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
        impl #generics #path::#name for #structure #bounds
    }
}

fn model(target: &Target, angles: &[bool], table: &TokenStream, has_energies: bool) -> TokenStream {
    let path = target.path;
    let [n, v] = target.sizes();
    let v = target.freedoms.has_base().then(|| quote!(, #v));
    let header = of_all(target, quote!(Model<#n #v>));
    // An unknown number of joints has no names; the body stands in for a table too.
    let (names, table) = if target.is_known {
        (quote!(Self::JOINT_NAMES), quote!(Self::table(self)))
    } else {
        (quote!([""; N]), table.clone())
    };
    let has_angles = target.is_known && angles.len() == target.freedoms.joints;
    let angles = has_angles.then(|| {
        quote! {
            const READS_ANGLE: [bool; #n] = [#(#angles),*];
        }
    });
    let energies = has_energies.then(|| energies(target));
    quote! {
        #header {
            const JOINT_NAMES: [&'static str; #n] = #names;
            #angles

            #[inline]
            fn table(&self) -> #path::Table<#n> {
                #table
            }

            #energies
        }
    }
}

/// The method of `Model` that returns both energies.
fn energies(target: &Target) -> TokenStream {
    let (path, [n, v]) = (target.path, target.sizes());
    let (mut name, mut place) = (quote!(energies), None);
    if target.freedoms.has_base() {
        name = quote!(energies_on);
        place = Some(quote!(base: &#path::Pose<f64>,));
    }
    let base = place.as_ref().map(|_| quote!(base,));
    quote! {
        #[inline]
        fn #name(
            &self,
            #place
            q: &#path::nalgebra::SVector<f64, #n>,
            qd: &#path::nalgebra::SVector<f64, #v>,
        ) -> ::core::option::Option<[f64; 2]> {
            ::core::option::Option::Some([
                Self::kinetic_energy(self, q, qd),
                Self::potential_energy(self, #base q),
            ])
        }
    }
}

fn evaluate(target: &Target, evaluation: &Evaluation) -> TokenStream {
    let path = target.path;
    let functions = &evaluation.functions;
    let (n, v) = (target.n(), target.v());
    let (name, state) = if target.freedoms.has_base() {
        (
            quote!(FloatingEvaluate<#n, #v>),
            quote!(FloatingState<#n, #v>),
        )
    } else {
        // One impl, for no joints, where their number is unknown: a check of the robot then infers the number.
        (quote!(Evaluate<#n>), quote!(State<#n>))
    };
    let header = start(target, [quote!(), quote!()], name);
    let parts = evaluation.parts.as_ref().map(|parts| {
        quote! {
            fn evaluate_parts(
                &self,
                state: &#path::#state,
                tau: &#path::nalgebra::SVector<f64, #v>,
                found_parts: &mut dyn ::core::ops::FnMut(&str, #path::Evaluation),
            ) {
                let real = |x: f64| -> f64 { x };
                #parts
            }
        }
    });
    quote! {
        #path::__with_std! {
            #header {
                fn evaluate_in<T: #path::Scalar>(
                    &self,
                    state: &#path::#state,
                    tau: &#path::nalgebra::SVector<f64, #v>,
                    real: fn(f64) -> T,
                ) -> #path::Evaluation<T> {
                    #functions
                }

                #parts
            }
        }
    }
}

/// `ForwardDynamics` of an arm whose only forward dynamics is by articulated bodies: it can be
/// simulated with that.
fn articulated_dynamics(target: &Target) -> TokenStream {
    let path = target.path;
    let (header, n) = header(target, quote!(ForwardDynamics));
    let vector = quote!(#path::nalgebra::SVector<T, #n>);
    let result = quote!(::core::result::Result<#vector, #path::SingularMassMatrix>);
    quote! {
        #header {
            #[inline]
            fn forward_dynamics<T: #path::Scalar>(
                &self,
                q: &#vector,
                qd: &#vector,
                tau: &#vector,
            ) -> #result {
                Self::forward_dynamics_aba(self, q, qd, tau)
            }

            #[inline(always)]
            fn forward_dynamics_at<T: #path::Scalar>(
                &self,
                sines: &impl #path::Inputs<T>,
                q: &#vector,
                qd: &#vector,
                tau: &#vector,
            ) -> #result {
                <Self as #path::Function<#path::functions::ForwardDynamicsAba, #n>>::at(
                    self,
                    #path::functions::ForwardDynamicsAba,
                    sines,
                    &(*q, *qd, *tau),
                )
            }
        }
    }
}
