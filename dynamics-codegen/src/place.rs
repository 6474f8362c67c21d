//! Where something stands.

use proc_macro2::{Ident, Span};

/// Where something stands, for the error about it.
#[derive(Clone, Copy, Debug)]
pub enum Place {
    /// In tokens, from one to another.
    Tokens {
        /// The first of them.
        first: Span,
        /// The last of them.
        last: Span,
    },
    /// In a file; both counted from 1.
    File {
        /// The line.
        line: usize,
        /// The column of the first letter.
        column: usize,
    },
}

impl Place {
    /// The start of a file, for what is wrong in all of it.
    #[cfg(feature = "files")]
    pub(crate) const START: Place = Place::File { line: 1, column: 1 };

    /// From the start of this place to the end of the other.
    pub(crate) fn to(self, end: impl Into<Place>) -> Place {
        match (self, end.into()) {
            (Place::Tokens { first, .. }, Place::Tokens { last, .. }) => {
                Place::Tokens { first, last }
            }
            (start, _) => start,
        }
    }

    /// The last token alone.
    pub(crate) fn end(self) -> Place {
        match self {
            Place::Tokens { last, .. } => last.into(),
            place => place,
        }
    }

    /// The place behind the quote at this one and so many letters.
    #[cfg(feature = "files")]
    pub(crate) fn inside(self, letters: usize) -> Place {
        match self {
            Place::File { line, column } => Place::File {
                line,
                column: column + 1 + letters,
            },
            place => place,
        }
    }

    /// The tokens that the compiler is to show: for what stands in no token, those of the call.
    pub(crate) fn tokens(self) -> [Span; 2] {
        match self {
            Place::Tokens { first, last } => [first, last],
            Place::File { .. } => [Span::call_site(); 2],
        }
    }

    /// Line and column of the start. Tokens have none outside of the compiler.
    pub(crate) fn position(self) -> (usize, usize) {
        match self {
            Place::Tokens { first, .. } if proc_macro::is_available() => {
                (first.unwrap().line(), first.unwrap().column())
            }
            Place::Tokens { .. } => (0, 0),
            Place::File { line, column } => (line, column),
        }
    }
}

impl From<Span> for Place {
    fn from(span: Span) -> Place {
        Place::Tokens {
            first: span,
            last: span,
        }
    }
}

impl From<&Ident> for Place {
    fn from(ident: &Ident) -> Place {
        ident.span().into()
    }
}
