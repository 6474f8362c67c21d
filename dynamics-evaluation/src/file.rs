//! Robots from files.

use core::fmt;
use std::path::{Path, PathBuf};

use dynamics_codegen::description::{Entry, Expr, ExprKind, Name, Place, Table};
use dynamics_codegen::files::{Format, MOST_BYTES, Request, bytes, model_beside, table, text};
use dynamics_codegen::{Audience, Error, Model};
use dynamics_symbolic::Function;
use dynamics_symbolic::exact::Rational;
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
                "{}:1:1: the name tells no format: expected a file that ends in `.toml`, `.json` or `.urdf`",
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

/// What is said of a robot besides its file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Besides {
    /// Entries in TOML. `lock`, `couple` and `allow` add to those of the file: a joint that both lock at different
    /// positions is a mistake. Each of `gravity`, `functions`, `base`, `tool`, `neglect` and `tests` takes the place of
    /// the file's, and a name in `let` that of the same name. `convention` and `joint` are the file's alone.
    pub entries: String,
    /// The first and the last link of the arm, which a URDF file needs; passed over for a table.
    pub chain: Option<[String; 2]>,
    /// Joints of a URDF file that are left out, with all that hangs on them; passed over for a table. `rest`, where no
    /// joint has that name, is all joints beside the chain that are not named; it may be locked, too.
    pub ignore: Vec<String>,
    /// How near an angle of a URDF file is to a multiple of a quarter turn that it is taken for, rad, and which share of
    /// an axis is zero; passed over for a table.
    pub round_angles: Option<f64>,
    /// Names that cells may use without a value, as those of the fields of a struct: they become the
    /// robot's fields, in this order.
    pub fields: Vec<String>,
    /// Functions that are derived besides those that are asked for. If one reads masses, the file has to have them.
    pub needed: Vec<Function>,
    /// The reader of messages, in whose words they say what to write.
    pub audience: Audience,
}

impl Besides {
    /// As a table. Its lines are counted behind the `lines` of the file, so that a mistake in one of them is not taken for
    /// one in the file.
    fn table(&self, stem: &str, lines: usize) -> Result<Table, Vec<Error>> {
        let entries = "\n".repeat(lines) + &self.entries;
        let mut table = table(stem, &entries, Format::Toml, &Request::default())?;
        table.audience = self.audience;
        table.needed.clone_from(&self.needed);
        let place = Place::File {
            line: lines + 1,
            column: 1,
        };
        let name = |name: &String| Name::new(name.as_str(), place);
        table.fields = self.fields.iter().map(name).collect();
        let chain = self.chain.as_ref();
        let chain = chain.map(|[first, last]| Entry::Chain(Some([name(first), name(last)])));
        table.entries.extend(chain);
        let ignore = self.ignore.iter().map(name).collect();
        table.entries.push(Entry::Ignore(Some(ignore)));
        if let Some(within) = self.round_angles {
            let number = Rational::try_from(within).unwrap_or(Rational::ZERO);
            let kind = ExprKind::Number(number);
            table
                .entries
                .push(Entry::RoundAngles(Some(Expr { kind, place })));
        }
        Ok(table)
    }
}

/// Reads a robot and the functions that are asked for.
///
/// # Errors
///
/// [`FileError`], with all mistakes of the file and of what is said besides.
pub fn read_file(path: &Path, besides: &Besides) -> Result<Model, FileError> {
    let text = read_text(path)?;
    let format = Format::of(path).ok_or_else(|| FileError::UnknownFormat(path.to_owned()))?;
    let stem = path.file_stem().and_then(|stem| stem.to_str());
    // A mistake at the end of a file may have the line behind its last one.
    let lines = text.lines().count() + 1;
    read(stem.unwrap_or("robot"), &text, format, besides, lines).map_err(|errors| {
        let mistakes = errors.into_iter().map(|error| mistake(path, lines, error));
        FileError::Mistakes(mistakes.collect())
    })
}

fn read(
    stem: &str,
    text: &str,
    format: Format,
    besides: &Besides,
    lines: usize,
) -> Result<Model, Vec<Error>> {
    let mut model = model_beside(stem, text, format, besides.table(stem, lines)?)?;
    if let Some((share, place)) = &model.neglect {
        let neglected = neglect(&model.robot, share.to_f64(&[]));
        model.robot = neglected.map_err(|refused| {
            vec![Error {
                place: *place,
                message: refused.to_string(),
            }]
        })?;
    }
    Ok(model)
}

/// The text of a file that is no longer than a robot's may be.
///
/// # Errors
///
/// [`FileError::Unreadable`], and a mistake where the bytes are no text.
pub fn read_text(path: &Path) -> Result<String, FileError> {
    let unreadable = |reason| FileError::Unreadable(path.to_owned(), reason);
    let bytes = bytes(path, MOST_BYTES).map_err(|error| unreadable(error.to_string()))?;
    text(bytes).map_err(|error| FileError::Mistakes(vec![mistake(path, usize::MAX, error)]))
}

/// A mistake with its place in a file of so many lines; one behind them is in what was said besides.
fn mistake(path: &Path, lines: usize, error: Error) -> FileMistake {
    let (line, column) = match error.place {
        Place::File { line, column } => (line, column),
        Place::Tokens { .. } => (1, 1),
    };
    let is_besides = line > lines;
    FileMistake {
        file: (!is_besides).then(|| path.to_owned()),
        line: if is_besides { line - lines } else { line },
        column,
        message: error.message,
    }
}

impl RuntimeRobot {
    /// The robot of a file, TOML in the macro's words or JSON, with the functions that the file asks
    /// for, or else those that a table has that asks for none. A URDF file needs more: see
    /// [`from_file_with`](Self::from_file_with).
    ///
    /// # Errors
    ///
    /// [`FileError`], with all mistakes of the file.
    pub fn from_file(path: impl AsRef<Path>) -> Result<Self, FileError> {
        RuntimeRobot::from_file_with(path, &Besides::default())
    }

    /// The robot of a file, with what is said besides: of a URDF file the first and the last link, and
    /// gravity.
    ///
    /// ```no_run
    /// # mod robot_dynamics {
    /// # pub use dynamics_evaluation as evaluation;
    /// # }
    /// use robot_dynamics::evaluation::{Besides, RuntimeRobot};
    ///
    /// let besides = Besides {
    ///     entries: "gravity = [0, 0, -9.81]".to_owned(),
    ///     chain: Some(["panda_link0", "panda_link8"].map(str::to_owned)),
    ///     ..Besides::default()
    /// };
    /// let panda = RuntimeRobot::from_file_with("panda.urdf", &besides)?;
    /// # Ok::<(), robot_dynamics::evaluation::FileError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`FileError`], with all mistakes of the file.
    pub fn from_file_with(path: impl AsRef<Path>, besides: &Besides) -> Result<Self, FileError> {
        let path = path.as_ref();
        let model = read_file(path, besides)?;
        let requests = model.requests.into_iter().map(|(request, _)| request);
        let arm = RuntimeRobot::new(model.robot, requests);
        arm.map_err(|error| FileError::Build(path.to_owned(), error))
    }
}
