//! Names of arguments and local variables, apart from the names around the call.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// Arguments and local variables of the generated code, except for those whose names end in `_`.
pub(crate) const NAMES: &str = "base q qd qdd tau jerk snap wrench order state sines real index x term forces pose \
    elbow solutions qd_r qdd_r at_state found_values found_parts all_values all_arms \
    nearest_pose pose_place of_pose is_singular on_circle a_number found_direction is_any";

/// The items in a scope of their own, in which primitive types, and the names of arguments and local variables,
/// mean nothing else.
///
/// A variable may not be named like a constant or a static in scope: the pattern would be that
/// constant. It may be named like a function, and a function of that name in a nearer scope hides the
/// constant.
pub(super) fn apart(items: &TokenStream) -> TokenStream {
    let names = NAMES
        .split(' ')
        .map(|name| Ident::new(name, Span::call_site()));
    quote! {
        #[allow(dead_code, unused_imports)]
        const _: () = {
            use ::core::primitive::{bool, f64, str, u32, usize};
            #(fn #names() {})*
            #items
        };
    }
}
