//! The languages.

/// A language that functions are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// The expansion of the macro.
    Rust,
    /// C99, with a header for C++ and a project where these are asked for.
    C,
    /// An ES module.
    JavaScript,
    /// A module for numpy.
    Python,
    /// MATLAB and Octave: a file for each function.
    Matlab,
    /// C for `casadi.external`, with derivatives.
    Casadi,
}

/// The facts about a language.
struct Row {
    name: &'static str,
    extension: &'static str,
    has_closed_forms: bool,
}

impl Language {
    /// All languages.
    pub const ALL: [Language; 6] = [
        Language::Rust,
        Language::C,
        Language::JavaScript,
        Language::Python,
        Language::Matlab,
        Language::Casadi,
    ];

    const fn row(self) -> Row {
        let (name, extension, has_closed_forms) = match self {
            Language::Rust => ("rust", "rs", true),
            Language::C => ("c", "c", true),
            Language::JavaScript => ("js", "mjs", true),
            Language::Python => ("python", "py", false),
            Language::Matlab => ("matlab", "m", false),
            Language::Casadi => ("casadi", "c", false),
        };
        Row {
            name,
            extension,
            has_closed_forms,
        }
    }

    /// The word for it: `js`.
    pub const fn name(self) -> &'static str {
        self.row().name
    }

    /// The language of that word.
    pub fn named(name: &str) -> Option<Self> {
        let mut all = Language::ALL.into_iter();
        all.find(|language| language.name() == name)
    }

    /// The end of the names of its sources: `mjs`.
    pub const fn extension(self) -> &'static str {
        self.row().extension
    }

    /// Whether it has inverse kinematics in closed form.
    pub const fn has_closed_forms(self) -> bool {
        self.row().has_closed_forms
    }
}
