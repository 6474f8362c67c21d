//! How long the long runs are.

/// How long the long runs are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Effort {
    /// Seconds of a test in the dev profile.
    Short,
    /// As long as the entries have them: for a release build.
    Full,
}

impl Effort {
    /// The effort that suits this build.
    pub fn of_this_build() -> Self {
        match cfg!(debug_assertions) {
            true => Effort::Short,
            false => Effort::Full,
        }
    }

    pub(crate) fn pick<T>(self, short: T, full: T) -> T {
        match self {
            Effort::Short => short,
            Effort::Full => full,
        }
    }
}
