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

/// A visible character for one that would act on a terminal or end a line, or that nobody sees: a control character, one
/// that changes the direction of writing, or one of no width. Any other one is itself.
pub fn visible(c: char) -> char {
    match c {
        // The pictures of control characters stand in their order from U+2400 on.
        '\0'..='\u{1f}' => {
            char::from_u32(0x2400 + u32::from(c)).unwrap_or(char::REPLACEMENT_CHARACTER)
        }
        '\u{7f}' => '\u{2421}',
        '\u{80}'..='\u{9f}'
        | '\u{ad}'
        | '\u{61c}'
        | '\u{180e}'
        | '\u{200b}'..='\u{200f}'
        | '\u{2028}'..='\u{202e}'
        | '\u{2060}'..='\u{206f}'
        | '\u{feff}' => char::REPLACEMENT_CHARACTER,
        _ => c,
    }
}

/// Lines of documentation, or of a comment, in which a name can do nothing but be read.
pub fn shown(lines: &str) -> String {
    let shown = |c| if c == '\n' { c } else { visible(c) };
    lines.chars().map(shown).collect()
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
pub fn line_names(lines: &[Option<Line>]) -> Vec<Option<String>> {
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
