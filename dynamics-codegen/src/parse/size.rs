//! Whether the tokens of a call are few, flat and short enough to be read.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::diagnose::{Diagnostics, Reported};
use crate::limits::{DEEPEST_DELIMITERS, MOST_LETTERS, MOST_TOKENS};
use crate::mistake::{Mistake, size};

/// Whether the tokens are few, flat and short enough to be read. Where they are not, one error says
/// so, and the result is the number of tokens at the start of the call that can be read all the same.
pub(super) fn check(
    tokens: &TokenStream,
    diagnostics: &Diagnostics,
) -> Result<(), (usize, Reported)> {
    let mut count = 0;
    let mut good = 0;
    // Groups on the heap: the recursion that this prevents is not needed to prevent it.
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(group) = open.last_mut() {
        let Some(token) = group.next() else {
            open.pop();
            good += usize::from(open.len() == 1);
            continue;
        };
        count += 1;
        if let Some(mistake) = excess(&token, count, open.len()) {
            return Err((good, diagnostics.error(token.span(), mistake)));
        }
        match token {
            TokenTree::Group(group) => open.push(group.stream().into_iter()),
            _ => good += usize::from(open.len() == 1),
        }
    }
    Ok(())
}

/// The limit that the `count`th token exceeds, that many groups deep.
fn excess(token: &TokenTree, count: usize, depth: usize) -> Option<Mistake> {
    if count > MOST_TOKENS {
        return Some(size::tokens());
    }
    match token {
        // A macro's fragments count too: they are read by recursion as well.
        TokenTree::Group(group) if depth > DEEPEST_DELIMITERS => {
            let what = match group.delimiter() {
                Delimiter::Parenthesis => "parentheses",
                Delimiter::Bracket => "brackets",
                Delimiter::Brace => "braces",
                Delimiter::None => "fragments",
            };
            Some(size::delimiters(what))
        }
        TokenTree::Ident(ident) => {
            let name = ident.to_string();
            (name.len() > MOST_LETTERS).then(|| size::name(&name))
        }
        _ => None,
    }
}
