//! Functions at many states that belong to a robot: several as one, those of frames, and all of one whose base moves.

use dynamics_symbolic::function::{Batch, Shape};
use dynamics_symbolic::{Function, Request, method_name};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::target::Target;

/// Whether a batch is no method of the runtime's trait `Batch`.
fn is_own(target: &Target, request: &Request) -> bool {
    target.freedoms.has_base() || request.function().is_none()
}

/// The batches of requests, unless a request has the name.
fn batches(
    target: &Target,
    requests: &[Request],
    is_meant: impl Fn(&Request) -> bool,
) -> Vec<Batch> {
    let is_taken = |name: &str| requests.iter().any(|request| request.name() == name);
    // Series on a base that moves are refused, and have no trait.
    let is_refused =
        |function: Function| target.freedoms.has_base() && *function.shape() == Shape::Series;
    let free = requests.iter().enumerate().filter(|(_, request)| {
        let name = request.name();
        let names = [format!("{name}_batch"), format!("par_{name}_batch")];
        let is_refused = request.function().is_some_and(is_refused);
        is_meant(request) && !is_refused && !names.iter().any(|name| is_taken(name))
    });
    let batch = |(index, request): (usize, &Request)| {
        let sizes = (target.sizes(), target.stubbed().generics(target.path));
        Batch::of_robot(request, index, &method_name(request), sizes, target.path)
    };
    free.map(batch).collect()
}

/// The batches of one robot that belong to it, beside its methods.
pub(super) fn of_one(target: &Target, requests: &[Request]) -> TokenStream {
    let (name, own) = (
        target.name,
        batches(target, requests, |r| is_own(target, r)),
    );
    methods(target, &own, &quote!(#name))
}

/// The batches in which every state has a robot of its own, where some belong to the robot: a type that has all of them.
/// It replaces the runtime's in the trait that reads fields.
pub(super) fn of_each(
    target: &Target,
    requests: &[Request],
    fields: &TokenStream,
) -> Option<TokenStream> {
    if !requests.iter().any(|r| is_own(target, r)) || !target.is_known {
        return None;
    }
    let Target {
        name,
        visibility,
        cfgs,
        path,
        ..
    } = target;
    let all = batches(target, requests, |_| true).into_iter();
    let all: Vec<Batch> = all.map(|batch| batch.of_each(name)).collect();
    let of_each = type_of_each(name);
    let methods = methods(target, &all, &quote!(#of_each<'_>));
    Some(quote! {
        #path::__with_std! {
            #cfgs
            #[doc(hidden)]
            #[allow(
                missing_debug_implementations,
                non_camel_case_types,
                unreachable_pub,
                clippy::all,
                clippy::pedantic,
                clippy::nursery
            )]
            #[derive(::core::clone::Clone, ::core::marker::Copy)]
            #visibility struct #of_each<'a>(&'a [#name]);

            #cfgs
            #[automatically_derived]
            impl<'a> ::core::convert::From<&'a [#name]> for #of_each<'a> {
                #[inline]
                fn from(all_arms: &'a [#name]) -> Self {
                    #of_each(all_arms)
                }
            }
        }
        #methods
        #fields
    })
}

/// The type of robots of which each state has one.
pub(super) fn type_of_each(name: &Ident) -> Ident {
    format_ident!("__{name}OfEach")
}

fn methods(target: &Target, batches: &[Batch], of: &TokenStream) -> TokenStream {
    let Target { cfgs, path, .. } = target;
    if batches.is_empty() {
        return TokenStream::new();
    }
    let [one, all] = [false, true].map(|parallel| {
        let methods = batches.iter().map(|batch| batch.method(parallel));
        quote! {
            #cfgs
            #[allow(dead_code, deprecated, clippy::all, clippy::pedantic, clippy::nursery)]
            impl #of { #(#methods)* }
        }
    });
    quote! {
        #path::__with_std! { #one }
        #path::__with_rayon! { #all }
    }
}
