//! How a command fails.

use std::fmt;
use std::io::IsTerminal as _;
use std::path::Path;

use dynamics_evaluation::FileMistake;

use crate::excerpt::{with_excerpts, without_controls};

/// The message of a failure, and the status of the process.
#[derive(Debug)]
pub(crate) struct Failure {
    /// The text found before the failure: it is printed as if nothing had failed.
    pub(crate) output: String,
    /// The mistake, and what was expected.
    pub(crate) message: String,
    /// The mistakes in a file that the message reports.
    mistakes: Vec<FileMistake>,
    /// 1; or 2 where the command line itself is wrong.
    pub(crate) status: u8,
}

impl Failure {
    /// A failure after some output.
    pub(crate) fn after(output: String, message: impl Into<String>) -> Self {
        Failure {
            output,
            message: message.into(),
            mistakes: Vec::new(),
            status: 1,
        }
    }

    /// A failure that the output tells.
    pub(crate) fn within(output: String) -> Self {
        Failure::after(output, "")
    }

    /// The failure with another output behind it.
    pub(crate) fn with_output(self, output: String) -> Self {
        Failure { output, ..self }
    }

    /// A mistake of a file as a whole.
    pub(crate) fn of_file(path: &Path, message: impl fmt::Display) -> Self {
        let message = format!("{}:1:1: {message}", path.display());
        Failure::after(String::new(), message)
    }

    /// A mistake of the command line.
    pub(crate) fn of_the_command_line(message: impl fmt::Display) -> Self {
        Failure {
            output: String::new(),
            message: format!("error: {message}\n\nFor more information, try '--help'."),
            mistakes: Vec::new(),
            status: 2,
        }
    }

    /// Mistakes in a file.
    pub(crate) fn of_mistakes(message: impl fmt::Display, mistakes: Vec<FileMistake>) -> Self {
        Failure {
            mistakes,
            ..Failure::after(String::new(), message.to_string())
        }
    }

    /// The text for standard error: on a terminal with the places in the file, elsewhere a line for each mistake. Nothing in it acts on the terminal, whatever the names of files and of what is in them: a log may be
    /// shown on one later.
    pub(crate) fn report(&self) -> String {
        if std::io::stderr().is_terminal() && !self.mistakes.is_empty() {
            with_excerpts(&self.mistakes, std::env::var_os("NO_COLOR").is_none())
        } else {
            without_controls(&self.message)
        }
    }
}

impl<E: std::error::Error> From<E> for Failure {
    fn from(error: E) -> Self {
        Failure::after(String::new(), error.to_string())
    }
}
