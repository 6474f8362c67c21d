//! Formulas that are no help.

/// Why there is no formula: it has so many terms, or more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong {
    /// The number of terms.
    pub terms: usize,
    /// Whether there are more.
    pub or_more: bool,
}

impl core::fmt::Display for TooLong {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let more = if self.or_more { "more than " } else { "" };
        write!(
            f,
            "too long: {more}{} terms; `robot-dynamics show`",
            self.terms
        )
    }
}
