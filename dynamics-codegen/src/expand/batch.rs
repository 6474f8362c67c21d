//! Several functions as one at many states.

use dynamics_symbolic::function::Batch;
use dynamics_symbolic::{Request, method_name};
use proc_macro2::TokenStream;
use quote::quote;

use super::target::Target;

/// The batches of several functions as one, which stand beside the methods.
pub(super) fn fused(target: &Target, requests: &[Request]) -> TokenStream {
    let Target {
        name, cfgs, path, ..
    } = target;
    let is_taken = |name: &str| requests.iter().any(|request| request.name() == name);
    let fused = requests.iter().enumerate().filter(|(_, request)| {
        let name = request.name();
        let names = [format!("{name}_batch"), format!("par_{name}_batch")];
        let is_own = target.freedoms.has_base() || request.function().is_none();
        is_own && !names.iter().any(|name| is_taken(name))
    });
    let batch = |(index, request): (usize, &Request)| {
        let sizes = target.is_known().then(|| [target.n(), target.v()]);
        Batch::of_robot(request, index, &method_name(request), sizes, path)
    };
    let fused: Vec<Batch> = fused.map(batch).collect();
    if fused.is_empty() {
        return TokenStream::new();
    }
    let [one, all] = [false, true].map(|parallel| {
        let methods = fused.iter().map(|batch| batch.method(parallel));
        quote! {
            #cfgs
            #[allow(dead_code, deprecated, clippy::all, clippy::pedantic, clippy::nursery)]
            impl #name { #(#methods)* }
        }
    });
    quote! {
        #path::__with_std! { #one }
        #path::__with_rayon! { #all }
    }
}
