//! The struct item.

use std::collections::BTreeSet;

use dynamics_symbolic::emit::shown;
use proc_macro2::{Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

use crate::call::{Field, Shape, Structure};

/// Types that a struct with an error in it may keep: they are `Copy` and need no path.
const PRIMITIVES: [&str; 15] = [
    "f64", "f32", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16", "u32", "u64", "u128",
    "usize", "bool",
];

/// The struct as it was written, with the usual derives where there is none, and more lines of
/// documentation.
pub(super) fn as_written(structure: &Structure, documentation: &[String]) -> TokenStream {
    item(structure, documentation, &|field| {
        let mut written = field.written.clone().into_iter();
        match (written.next(), written.next()) {
            (Some(TokenTree::Ident(name)), None) if name == "f64" => double(name.span()),
            _ => field.written.clone(),
        }
    })
}

/// `f64`, whatever has that name around the call.
fn double(place: Span) -> TokenStream {
    quote_spanned!(place=> ::core::primitive::f64)
}

/// The struct as it was meant: wrong fields are `f64`.
pub(super) fn repaired(structure: &Structure) -> TokenStream {
    item(structure, &[], &|field| {
        if PRIMITIVES.contains(&field.written.to_string().as_str()) {
            field.written.clone()
        } else {
            double(Span::call_site())
        }
    })
}

fn item(
    structure: &Structure,
    documentation: &[String],
    field_type: &dyn Fn(&Field) -> TokenStream,
) -> TokenStream {
    let Structure {
        attributes,
        visibility,
        name,
        ..
    } = structure;
    // `Eq` on a struct without fields would be gone with the first field.
    let derive = (!structure.has_derive).then(|| {
        quote! {
            #[derive(Clone, Copy, Debug, PartialEq)]
            #[allow(clippy::derive_partial_eq_without_eq)]
        }
    });
    let fields = fields(structure).map(|field| {
        let Field {
            attributes,
            visibility,
            name,
            ..
        } = field;
        let name = name.iter();
        let written = field_type(field);
        quote!(#attributes #visibility #(#name:)* #written)
    });
    let documentation = documentation.iter().map(|line| shown(line));
    // The compiler shows the line of the struct in place of the whole call. It takes the struct for one without a macro, in
    // which it minds more.
    let allowed = (!structure.is_alone).then(|| quote!(#[allow(unreachable_pub)]));
    let item = match (name.span(), structure.shape) {
        (line, Shape::Unit) => quote_spanned!(line=> struct #name;),
        (line, Shape::Named) => quote_spanned!(line=> struct #name { #(#fields),* }),
        (line, Shape::Tuple) => quote_spanned!(line=> struct #name( #(#fields),* );),
    };
    quote!(#derive #allowed #attributes #(#[doc = #documentation])* #visibility #item)
}

/// The fields, without one whose name stands twice.
fn fields(structure: &Structure) -> impl Iterator<Item = &Field> {
    let mut seen = BTreeSet::new();
    let is_first = move |field: &&Field| match &field.name {
        Some(name) => seen.insert(name.to_string()),
        None => true,
    };
    structure.fields.iter().filter(is_first)
}
