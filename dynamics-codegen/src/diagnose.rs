//! Errors of one macro call: collected, then reported all together.

use std::cell::{Cell, RefCell};

use proc_macro2::TokenStream;
use quote::quote_spanned;

use crate::audience::Audience;
use crate::description::FileName;
use crate::limits::MOST_ERRORS;
use crate::mistake::Mistake;
use crate::place::Place;

/// A mistake in a table.
#[derive(Clone, Debug)]
pub struct Error {
    /// Where.
    pub place: Place,
    /// The rule that is broken: `urdf::no_body`.
    pub rule: &'static str,
    /// The text: what is wrong, what was expected, and what to write instead where that is known.
    pub message: String,
}

impl Error {
    /// A mistake in the words of an audience.
    pub(crate) fn new(place: Place, mistake: &Mistake, audience: Audience) -> Error {
        Error {
            place,
            rule: mistake.rule(),
            message: mistake.text_for(audience).to_owned(),
        }
    }
}

/// Evidence that an error was reported: whoever receives it has nothing to add.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reported(());

/// Collects the errors of one macro call.
///
/// Dropping it without [`Diagnostics::into_compile_errors`] would lose errors, so
/// that panics.
#[derive(Debug, Default)]
pub(crate) struct Diagnostics {
    errors: RefCell<Vec<(Place, Mistake)>>,
    file: RefCell<Option<(FileName, Audience)>>,
    /// Errors that were taken out again.
    taken: Cell<usize>,
}

impl Diagnostics {
    /// Nothing reported yet.
    pub(crate) fn new() -> Diagnostics {
        Diagnostics::default()
    }

    /// Says which file the places in a file are in, and in whose words its mistakes are reported.
    #[cfg(feature = "files")]
    pub(crate) fn reading(&self, file: &FileName, audience: Audience) {
        *self.file.borrow_mut() = Some((file.clone(), audience));
    }

    /// Reports an error.
    pub(crate) fn error(&self, at: impl Into<Place>, mistake: Mistake) -> Reported {
        let shown = self.errors.borrow().len();
        if shown < MOST_ERRORS {
            let mistake = if shown + 1 == MOST_ERRORS {
                mistake.with_others()
            } else {
                mistake
            };
            self.errors.borrow_mut().push((at.into(), mistake));
        }
        Reported(())
    }

    /// Whether no further error is shown.
    pub(crate) fn is_full(&self) -> bool {
        self.count() + self.taken.get() >= MOST_ERRORS
    }

    /// How many errors there are.
    pub(crate) fn count(&self) -> usize {
        self.errors.borrow().len()
    }

    /// Takes out the errors behind the first `count`, to report them later if they matter then. They count as shown
    /// all the same: reading ends at the last that can be.
    pub(crate) fn take_behind(&self, count: usize) -> Vec<(Place, Mistake)> {
        let taken = self.errors.borrow_mut().split_off(count);
        self.taken.set(self.taken.get() + taken.len());
        taken
    }

    /// Drops the errors: the same is said elsewhere.
    pub(crate) fn forget(self) {
        self.errors.take();
    }

    /// Reads something of which no errors are reported.
    #[cfg(feature = "files")]
    pub(crate) fn without<T>(read: impl FnOnce(&Diagnostics) -> T) -> T {
        let diagnostics = Diagnostics::new();
        let value = read(&diagnostics);
        diagnostics.forget();
        value
    }

    /// Whether nothing was reported.
    pub(crate) fn is_empty(&self) -> bool {
        self.errors.borrow().is_empty()
    }

    /// The errors, from the top to the end: of the call, then of its file.
    pub(crate) fn into_errors(self) -> Vec<(Place, Mistake)> {
        let mut errors = self.errors.take();
        let is_in_file = |place: &Place| matches!(place, Place::File { .. });
        errors.sort_by_key(|(place, _)| (is_in_file(place), place.position()));
        errors
    }

    /// The same, each in the words of that audience.
    pub(crate) fn shown_to(self, audience: Audience) -> Vec<Error> {
        let errors = self.into_errors().into_iter();
        let error = |(place, mistake)| Error::new(place, &mistake, audience);
        errors.map(error).collect()
    }

    /// One `compile_error!` for each error.
    pub(crate) fn into_compile_errors(self) -> TokenStream {
        let file = self.file.take();
        let errors = self.into_errors().into_iter();
        let errors = errors.map(|(place, mistake)| {
            let (tokens, message) = match (&file, place) {
                (Some((file, audience)), Place::File { line, column }) => {
                    let message = mistake.text_for(*audience);
                    (
                        file.place,
                        format!("{}:{line}:{column}: {message}", file.path),
                    )
                }
                _ => (place, mistake.to_string()),
            };
            let [first, last] = tokens.tokens();
            // The compiler underlines from the path's span to the braces' span.
            let path = quote_spanned!(first=> ::core::compile_error!);
            let body = quote_spanned!(last=> { #message });
            quote_spanned!(first=> #path #body)
        });
        errors.collect()
    }

    /// The messages alone, in the order of reporting.
    #[cfg(test)]
    pub(crate) fn into_messages(self) -> Vec<String> {
        let errors = self.errors.take().into_iter();
        errors.map(|(_, mistake)| mistake.to_string()).collect()
    }
}

impl Drop for Diagnostics {
    fn drop(&mut self) {
        if !self.is_empty() && !std::thread::panicking() {
            panic!("errors of a macro call were dropped unread");
        }
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::Span;

    use super::*;
    use crate::mistake;

    #[test]
    fn every_error_becomes_a_compile_error() {
        let diagnostics = Diagnostics::new();
        diagnostics.error(Span::call_site(), mistake::attribute());
        diagnostics.error(Span::call_site(), mistake::given_twice("a \"quoted\" word"));
        let tokens = diagnostics.into_compile_errors().to_string();
        assert_eq!(tokens.matches("compile_error !").count(), 2);
        assert!(tokens.contains(r#""`a \"quoted\" word` is given twice""#));
    }

    #[test]
    fn no_error_leaves_no_tokens() {
        assert!(Diagnostics::new().into_compile_errors().is_empty());
    }

    #[test]
    #[should_panic(expected = "dropped unread")]
    fn errors_cannot_be_lost() {
        Diagnostics::new().error(Span::call_site(), mistake::attribute());
    }
}
