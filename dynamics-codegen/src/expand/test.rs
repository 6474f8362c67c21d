//! The test that `tests: true` requests.

use dynamics_symbolic::function::plain;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::target::Target;
use crate::call::Structure;

/// A test beside the struct: the model against the numeric recursive Newton-Euler
/// algorithm.
///
/// The check stands where the struct does, so that it sees the struct in the body of a
/// function too. There the compiler runs no test and warns of one; only a module around the
/// test can silence that. The glob finds the check where the struct is an item of a module,
/// and hides the module's own; from within a body it finds nothing, and the module's own,
/// which never runs, stands in.
pub(super) fn agrees_with_newton_euler(target: &Target, structure: &Structure) -> TokenStream {
    let Target {
        name, cfgs, path, ..
    } = target;
    // The struct's own letters: structs whose names differ in case alone may be neighbours.
    let prefix = name.to_string();
    let prefix = plain(&prefix);
    let [check, module] = ["agrees_with_recursive_newton_euler", "model"]
        .map(|rest| Ident::new(&format!("{prefix}_{rest}"), Span::call_site()));
    let names = structure.fields.iter().filter_map(|f| f.name.as_ref());
    let fields = names.enumerate().map(|(index, field)| {
        let value = Literal::f64_suffixed(sample(index));
        quote!(#field: #value)
    });
    quote! {
        #cfgs
        #[cfg(test)]
        #[allow(dead_code, deprecated, non_snake_case, clippy::all, clippy::pedantic, clippy::nursery)]
        fn #check() {
            #path::check_against_rnea(&#name { #(#fields),* }).assert_ok();
        }

        #cfgs
        #[cfg(test)]
        #[allow(
            dead_code, non_snake_case, unnameable_test_items, unused_imports,
            clippy::all, clippy::pedantic, clippy::nursery
        )]
        mod #module {
            fn #check() {
                ::core::unreachable!("no test runs in the body of a function")
            }

            #[test]
            fn agrees_with_recursive_newton_euler() {
                use super::*;
                #check();
            }
        }
    }
}

/// A value for the field of that index: in [0.5, 1.5), all of them different (the
/// multiples of the golden ratio's inverse, modulo 1, three decimals).
fn sample(index: usize) -> f64 {
    let fraction = ((index + 1) as f64 * 0.618_033_988_749_894_9).fract();
    ((0.5 + fraction) * 1000.0).floor() / 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_in_range_and_different() {
        let mut samples: Vec<f64> = (0..50).map(sample).collect();
        assert!(samples.iter().all(|x| (0.5..1.5).contains(x)));
        samples.sort_by(f64::total_cmp);
        assert!(samples.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
