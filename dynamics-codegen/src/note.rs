//! Notes on values that the user of a robot may not expect.

use std::fmt;

/// The weight of something that is found in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The file is no robot as it stands, or one that other commands refuse.
    Error,
    /// The file is hardly meant so.
    Warning,
    /// The file is right, and its user should know of this.
    Note,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        })
    }
}

/// A note on a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// The rule by which it is told.
    pub rule: &'static str,
    /// How much it matters.
    pub severity: Severity,
    /// The text.
    pub text: String,
    /// The line and the column in the file, from 1 on; the first ones if it is about the whole file.
    pub position: (usize, usize),
}

impl Note {
    pub(crate) fn new(rule: &'static str, severity: Severity, text: impl Into<String>) -> Note {
        let text = text.into();
        Note {
            rule,
            severity,
            text,
            position: (1, 1),
        }
    }

    /// The same, of a place in a file.
    #[cfg(feature = "files")]
    pub(crate) fn at(self, line: usize, column: usize) -> Note {
        let position = (line, column);
        Note { position, ..self }
    }
}
