//! Identifiers in generated code, the number of joints, and tuples of values.

use crate::function::Request;
use crate::program::Line;
use proc_macro2::{Ident, Literal, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, quote};

/// A name of the generated code's own, which no name of the user's can meet.
pub(super) fn ident(name: &str) -> Ident {
    Ident::new(name, proc_macro2::Span::mixed_site())
}

/// A variable of the generated code's own. Nobody writes a `_` at the end of a constant's name: a pattern that is the name
/// of a constant around the call would be that constant.
pub(super) fn variable(name: &str) -> Ident {
    ident(&format!("{name}_"))
}

/// An operator of one letter.
pub(super) fn punct(operator: char) -> TokenTree {
    Punct::new(operator, Spacing::Alone).into()
}

/// The identifier of a field of the user's struct.
pub fn field(name: &str) -> Ident {
    let span = proc_macro2::Span::call_site();
    match name.strip_prefix("r#") {
        Some(raw) => Ident::new_raw(raw, span),
        None => Ident::new(name, span),
    }
}

/// The variables of the results that have a line.
pub(super) fn line_names(lines: &[Option<Line>]) -> Vec<Option<String>> {
    let mut count = 0;
    let name = |line: &Option<Line>| {
        line.map(|_| {
            count += 1;
            format!("t_{count}")
        })
    };
    lines.iter().map(name).collect()
}

/// The number of joints as a token: a constant's name where `dof` is zero.
pub(super) fn number_of_joints(dof: usize) -> TokenStream {
    match dof {
        0 => quote!(N),
        _ => Literal::usize_unsuffixed(dof).into_token_stream(),
    }
}

/// The values of a method, or their types, from those of its parts.
pub(super) fn in_tuple(request: &Request, parts: Vec<TokenStream>) -> TokenStream {
    if request.is_tuple() {
        quote!((#(#parts),*))
    } else {
        parts.into_iter().collect()
    }
}
