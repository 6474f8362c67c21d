//! The test that `tests: true` asks for.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::Target;
use crate::syntax::Structure;
use crate::validate::plain;

/// A test module beside the struct: the model against the numeric recursive
/// Newton-Euler algorithm.
pub(super) fn agrees_with_newton_euler(target: &Target, structure: &Structure) -> TokenStream {
    let Target {
        name, cfgs, path, ..
    } = target;
    let module = Ident::new(
        &format!("{}_model", snake_case(&plain(name))),
        Span::call_site(),
    );
    let names = structure.fields.iter().filter_map(|f| f.name.as_ref());
    let fields = names.enumerate().map(|(index, field)| {
        let value = Literal::f64_suffixed(sample(index));
        quote!(#field: #value)
    });
    quote! {
        #cfgs
        #[cfg(test)]
        mod #module {
            #[test]
            fn agrees_with_recursive_newton_euler() {
                let robot = super::#name { #(#fields),* };
                #path::check_against_rnea(&robot).assert_ok();
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

/// `TwoLink` to `two_link`.
fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    let mut previous = None;
    for letter in name.chars() {
        let after_word = previous.is_some_and(|p: char| p.is_lowercase() || p.is_numeric());
        if letter.is_uppercase() && after_word {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
        previous = Some(letter);
    }
    snake
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_snake_case() {
        assert_eq!(snake_case("TwoLink"), "two_link");
        assert_eq!(snake_case("Puma560"), "puma560");
        assert_eq!(snake_case("UR5e"), "ur5e");
        assert_eq!(snake_case("Arm2Link"), "arm2_link");
    }

    #[test]
    fn samples_are_in_range_and_different() {
        let mut samples: Vec<f64> = (0..50).map(sample).collect();
        assert!(samples.iter().all(|x| (0.5..1.5).contains(x)));
        samples.sort_by(f64::total_cmp);
        assert!(samples.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
