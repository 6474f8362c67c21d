//! Robots from files.

use core::fmt;
use std::path::{Path, PathBuf};

use dynamics_codegen::Model;
use dynamics_codegen::description::{Entry, Place};
use dynamics_codegen::files::{Format, Request, table};
use dynamics_symbolic::neglect::neglect;

use crate::{BuildError, RuntimeRobot};

/// Why a file gives no robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileError {
    /// The file could not be read, with the system's reason.
    Unreadable(PathBuf, String),
    /// The name of the file tells no format.
    UnknownFormat(PathBuf),
    /// The file says something else than a robot: all mistakes in it, from the top to the end.
    Mistakes(Vec<FileMistake>),
    /// The robot has no functions.
    Build(PathBuf, BuildError),
}

/// A mistake in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileMistake {
    /// The file; none where the mistake is in what was said besides.
    pub file: Option<PathBuf>,
    /// The line, counted from 1.
    pub line: usize,
    /// The column of the first letter, counted from 1.
    pub column: usize,
    /// What is wrong, and what was expected.
    pub message: String,
}

impl fmt::Display for FileMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let FileMistake {
            file,
            line,
            column,
            message,
        } = self;
        match file {
            Some(file) => write!(f, "{}:{line}:{column}: {message}", file.display()),
            None => f.write_str(message),
        }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FileError::Unreadable(file, reason) => {
                write!(f, "{}:1:1: cannot be read: {reason}", file.display())
            }
            FileError::UnknownFormat(file) => write!(
                f,
                "{}:1:1: the name tells no format: expected a file that ends in `.toml` or `.json`",
                file.display()
            ),
            FileError::Mistakes(mistakes) => {
                let lines: Vec<_> = mistakes.iter().map(FileMistake::to_string).collect();
                f.write_str(&lines.join("\n"))
            }
            FileError::Build(file, error) => write!(f, "{}:1:1: {error}", file.display()),
        }
    }
}

impl core::error::Error for FileError {}

/// Reads a robot and what is asked for; `besides` are entries in TOML that take the place of those of the
/// file, or join them: `gravity`, `functions`, `lock`.
///
/// # Errors
///
/// [`FileError`], with all mistakes of the file.
pub fn read_file(path: &Path, besides: &str) -> Result<Model, FileError> {
    let text = std::fs::read_to_string(path);
    let text = text.map_err(|error| FileError::Unreadable(path.to_owned(), error.to_string()))?;
    let format = Format::of(path).ok_or_else(|| FileError::UnknownFormat(path.to_owned()))?;
    let stem = path
        .file_stem()
        .and_then(|stem| stem.to_str())
        .unwrap_or("robot");
    let mistakes = |file: Option<&Path>, errors: Vec<dynamics_codegen::Error>| {
        let errors = errors.into_iter();
        FileError::Mistakes(errors.map(|error| mistake(file, error)).collect())
    };
    let mut robot = table(stem, &text, format, &Request::default())
        .map_err(|errors| mistakes(Some(path), errors))?;
    let besides = table(stem, besides, Format::Toml, &Request::default())
        .map_err(|errors| mistakes(None, errors))?;
    for entry in besides.entries {
        let same =
            |other: &Entry| core::mem::discriminant(other) == core::mem::discriminant(&entry);
        robot.entries.retain(|other| !same(other));
        robot.entries.push(entry);
    }
    robot.keys.extend(besides.keys);
    let mut model =
        dynamics_codegen::check(&robot).map_err(|errors| mistakes(Some(path), errors))?;
    if let Some((share, place)) = &model.neglect {
        model.robot = neglect(&model.robot, share.to_f64(&[])).map_err(|refused| {
            let message = refused.to_string();
            mistakes(
                Some(path),
                vec![dynamics_codegen::Error {
                    place: *place,
                    message,
                }],
            )
        })?;
    }
    Ok(model)
}

fn mistake(file: Option<&Path>, error: dynamics_codegen::Error) -> FileMistake {
    let (line, column) = match error.place {
        Place::File { line, column } => (line, column),
        Place::Tokens { .. } => (1, 1),
    };
    FileMistake {
        file: file.map(Path::to_owned),
        line,
        column,
        message: error.message,
    }
}

impl RuntimeRobot {
    /// The robot of a file, TOML in the macro's words or JSON, with the functions that the file asks
    /// for, or else those that a table has that asks for none.
    ///
    /// # Errors
    ///
    /// [`FileError`], with all mistakes of the file.
    pub fn from_file(path: impl AsRef<Path>) -> Result<Self, FileError> {
        let path = path.as_ref();
        let model = read_file(path, "")?;
        let requests = model.requests.into_iter().map(|(request, _)| request);
        let arm = RuntimeRobot::new(model.robot, requests);
        arm.map_err(|error| FileError::Build(path.to_owned(), error))
    }
}
