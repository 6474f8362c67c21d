//! Things that are found in a file, by rules with names.

use std::fmt;

/// The weight of something that is found in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

/// Something that breaks a rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The line, counted from 1.
    pub line: usize,
    /// The column of the first letter, counted from 1.
    pub column: usize,
    /// The name of the rule.
    pub rule: &'static str,
    /// Its weight.
    pub severity: Severity,
    /// The text: what is found.
    pub message: String,
    /// How to mend it; none if the message says that.
    pub remedy: Option<String>,
}

impl Finding {
    /// A finding in the whole of a table.
    pub(crate) fn of_all(rule: &'static str, severity: Severity, message: String) -> Finding {
        Finding {
            line: 1,
            column: 1,
            rule,
            severity,
            message,
            remedy: None,
        }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Finding {
            line,
            column,
            rule,
            severity,
            message,
            remedy,
        } = self;
        write!(f, "{line}:{column}: {severity}: {message} [{rule}]")?;
        match remedy {
            Some(remedy) => write!(f, ": {remedy}"),
            None => Ok(()),
        }
    }
}
