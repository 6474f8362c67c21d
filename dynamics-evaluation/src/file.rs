//! Robots from files.

use core::fmt;
use std::path::{Path, PathBuf};

use dynamics_codegen::description::{Entry, Expr, FileName, Masses, Name, Place, Table};
use dynamics_codegen::files::{
    Format, MOST_BYTES, Request, bytes, file_named, joined, model_beside, table, text,
};
use dynamics_codegen::{Audience, Error, Model};
use dynamics_symbolic::Function;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::neglect::neglect;
use dynamics_symbolic::robot::Value;

use crate::{BuildError, RuntimeRobot};

/// Why a file gives no robot.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileError {
    /// The file could not be read: the reason, and the number of the system's error, where it is one.
    Unreadable(PathBuf, String, Option<i32>),
    /// The name of the file tells no format.
    UnknownFormat(PathBuf),
    /// The file says something else than a robot: all mistakes in it, from the top to the end.
    Mistakes(Vec<FileMistake>),
    /// The robot has no functions.
    Build(PathBuf, BuildError),
}

/// A mistake in a file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct FileMistake {
    /// The file, `TOML` for a text; none if the mistake is in the options.
    pub file: Option<PathBuf>,
    /// The line, counted from 1.
    pub line: usize,
    /// The column of the first letter, counted from 1.
    pub column: usize,
    /// The rule that is broken: `urdf::no_body`.
    pub rule: &'static str,
    /// The mistake, and what was expected.
    pub message: String,
}

impl fmt::Display for FileMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let FileMistake {
            file,
            line,
            column,
            message,
            ..
        } = self;
        match file {
            Some(file) => write!(f, "{}:{line}:{column}: {message}", file.display()),
            None => f.write_str(message),
        }
    }
}

impl FileError {
    /// All that is wrong, each with its place: of a file that is not read, its start.
    #[doc(hidden)]
    pub fn mistakes(&self) -> Vec<FileMistake> {
        let whole = |file: &PathBuf, rule, message| {
            vec![FileMistake {
                file: Some(file.clone()),
                line: 1,
                column: 1,
                rule,
                message,
            }]
        };
        match self {
            FileError::Unreadable(file, reason, _) => whole(
                file,
                "file::unreadable",
                format!("cannot be read: {reason}"),
            ),
            FileError::UnknownFormat(file) => {
                let message = "the name tells no format: expected a file that ends in `.toml`, `.json` or `.urdf`";
                whole(file, "file::unknown_format", message.to_owned())
            }
            FileError::Mistakes(mistakes) => mistakes.clone(),
            FileError::Build(file, error) => whole(file, "not_proven", error.to_string()),
        }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mistakes = self.mistakes();
        let lines: Vec<_> = mistakes.iter().map(FileMistake::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl core::error::Error for FileError {}

/// Options by which a robot is read from a file or a text.
///
/// ```
/// # mod robot_dynamics {
/// # pub use dynamics_evaluation as evaluation;
/// # }
/// use robot_dynamics::evaluation::ReadOptions;
///
/// let options = ReadOptions::new()
///     .chain(["panda_link0", "panda_link8"])
///     .entries("gravity = [0, 0, -9.81]")
///     .functions(["inverse_dynamics", "mass_matrix"]);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[must_use]
pub struct ReadOptions {
    entries: String,
    functions: Option<Vec<String>>,
    chain: Option<Vec<String>>,
    ignore: Vec<String>,
    round_angles: Option<f64>,
    fields: Vec<String>,
    names_are_fields: bool,
    needed: Vec<Function>,
    audience: Audience,
    keeps_links: bool,
    masses: Masses,
}

fn owned(names: impl IntoIterator<Item = impl Into<String>>) -> Vec<String> {
    names.into_iter().map(Into::into).collect()
}

impl ReadOptions {
    /// Nothing besides the file.
    pub fn new() -> Self {
        ReadOptions::default()
    }

    /// Entries in TOML. `lock`, `couple` and `allow` add to those of the file: a joint that both lock at different
    /// positions is a mistake. Each of `gravity`, `functions`, `base`, `tool`, `neglect` and `tests` takes the place of
    /// the file's, and a name in `let` that of the same name. `convention` and `joint` are the file's alone. Cells that a
    /// joint of the file lacks, or has wrong, stand in `[joints.elbow]`: `motor`, `friction`, `spring`, `limits`,
    /// `torque_limit`, `velocity_limit` and `allow`.
    ///
    /// They are lines behind those that were given before.
    pub fn entries(mut self, toml: &str) -> Self {
        self.entries += toml;
        self.entries.push('\n');
        self
    }

    /// The names of the functions, in place of those that the file names: `default` are those of a file that names
    /// none. A method that returns several functions is an entry, `functions = [{ control_terms = ["mass_matrix", ..] }]`.
    pub fn functions(mut self, names: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.functions = Some(owned(names));
        self
    }

    /// The link of a URDF file at which the robot begins, and the tips to which its joints lead: an arm has one, and
    /// without tips the robot is all that the link carries. The whole tree of the file is read if this is left out.
    /// Passed over for a table.
    pub fn chain(mut self, links: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.chain = Some(owned(links));
        self
    }

    /// Joints of a URDF file that are left out, with all that hangs on them; passed over for a table. `rest`, where no
    /// joint has that name, is all joints beside the chain that are not named; it may be locked, too.
    pub fn ignore(mut self, joints: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.ignore = owned(joints);
        self
    }

    /// The distance from a multiple of a quarter turn, rad, within which an angle of a URDF file is taken for it. Smaller
    /// shares of an axis are zero. Passed over for a table.
    pub fn round_angles(mut self, within: f64) -> Self {
        self.round_angles = Some(within);
        self
    }

    /// Names that cells may use without a value, as those of the fields of a struct: they become the
    /// robot's fields, in this order.
    pub fn fields(mut self, names: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.fields = owned(names);
        self
    }

    /// Names in cells that nothing binds become fields, too, in the order in which they are read; unless the file closes the
    /// list by `fields = ["m1", "l1"]`, where another name is a mistake. They are those of the file, or of the entries beside
    /// a URDF file, which has none.
    ///
    /// ```
    /// # mod robot_dynamics {
    /// # pub use dynamics_evaluation as evaluation;
    /// # }
    /// use robot_dynamics::evaluation::{ReadOptions, RuntimeRobot};
    ///
    /// let table = r#"
    ///     convention = "modified"
    ///     gravity = [0, "-g", 0]
    ///     [[joint]]
    ///     name = "pivot"
    ///     type = "revolute"
    ///     mass = "m"
    ///     com = ["l", 0, 0]
    /// "#;
    /// let options = ReadOptions::new().functions(["gravity_vector"]).names_are_fields();
    /// let mut arm = RuntimeRobot::from_toml(table, &options)?;
    /// assert_eq!(arm.field_names(), ["g", "m", "l"]);
    /// arm.set_fields(&[10.0, 3.0, 0.5])?;
    /// assert_eq!(arm.gravity_vector(&[0.0])?[0], 15.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn names_are_fields(mut self) -> Self {
        self.names_are_fields = true;
        self
    }

    /// Functions that are derived besides those that are requested: if one reads masses, the file has to have them.
    /// Messages speak to somebody who typed a command line.
    #[doc(hidden)]
    pub fn for_command(mut self, needed: Vec<Function>) -> Self {
        (self.needed, self.audience) = (needed, Audience::Command);
        self
    }

    /// Whether all links of a URDF file are frames of the robot, and not only those that a function names.
    #[doc(hidden)]
    pub fn keep_links(mut self, keeps: bool) -> Self {
        self.keeps_links = keeps;
        self
    }

    /// Whether masses are read, and those that are missing told.
    #[doc(hidden)]
    pub fn masses(mut self, masses: Masses) -> Self {
        self.masses = masses;
        self
    }

    /// As a table, whose lines are counted behind the `lines` of the file: no mistake in them is taken for one in the file.
    /// The functions are the first of them.
    fn table(&self, robot: &str, lines: usize) -> Result<Table, Vec<Error>> {
        let names = self.functions.as_ref();
        let functions = names.map_or(String::new(), |names| format!("functions = {names:?}"));
        let entries = "\n".repeat(lines) + &functions + "\n" + &self.entries;
        let mut table = table(robot, &entries, Format::Toml, &Request::default())?;
        (table.audience, table.keeps_links) = (self.audience, self.keeps_links);
        table.masses = self.masses;
        table.needed.clone_from(&self.needed);
        if self.audience == Audience::Command {
            // Options hold values: a word in one is a slip, not a field.
            table.mentions.clear();
        }
        let place = Place::File {
            line: lines + 1,
            column: 1,
        };
        let name = |name: &String| Name::new(name.as_str(), place);
        table.fields = self.fields.iter().map(name).collect();
        table.names_are_fields = self.names_are_fields;
        if let Some(links) = &self.chain {
            let links = links.iter().map(name).collect();
            table.entries.push(Entry::Chain(Some(links)));
        }
        if !self.ignore.is_empty() {
            let ignore = self.ignore.iter().map(name).collect();
            table.entries.push(Entry::Ignore(Some(ignore)));
        }
        if let Some(within) = self.round_angles {
            let number = Rational::try_from(within).unwrap_or(Rational::ZERO);
            let number = Expr::known(Value::Rational(number), place);
            table.entries.push(Entry::RoundAngles(Some(number)));
        }
        Ok(table)
    }
}

/// Reads a robot and the functions that are requested.
///
/// # Errors
///
/// [`FileError`], with all mistakes of the file and of the options.
#[doc(hidden)]
pub fn read_file(path: &Path, options: &ReadOptions) -> Result<Model, FileError> {
    let text = read_text(path)?;
    let format = Format::of(path).ok_or_else(|| FileError::UnknownFormat(path.to_owned()))?;
    read(path, &text, format, options)
}

/// Reads a robot from the text of a file, whose name tells the format: `TOML` is that of a table.
///
/// # Errors
///
/// [`FileError`], with all mistakes of the text and of the options.
#[doc(hidden)]
pub fn read_source(path: &Path, text: &str, options: &ReadOptions) -> Result<Model, FileError> {
    let is_text = path == Path::new(TEXT);
    let format = if is_text {
        Some(Format::Toml)
    } else {
        Format::of(path)
    };
    let format = format.ok_or_else(|| FileError::UnknownFormat(path.to_owned()))?;
    read(path, text, format, options)
}

/// The name of a text in messages.
const TEXT: &str = "TOML";

fn read(
    path: &Path,
    text: &str,
    format: Format,
    options: &ReadOptions,
) -> Result<Model, FileError> {
    let name = path.file_stem().and_then(|stem| stem.to_str());
    let name = name.unwrap_or("robot");
    let Some(file) = file_named(text, format) else {
        let sources = [(path, lines(text))];
        let beside = options.table(name, lines(text));
        let model = beside.and_then(|beside| model_beside(name, text, format, beside));
        return complete(model, &sources);
    };
    let (urdf, of_robot) = text_named(path, &file)?;
    let before = lines(&of_robot);
    let sources = [(&*urdf, before), (path, lines(text))];
    // Lines of the table are counted behind those of its file.
    let behind = "\n".repeat(before) + text;
    let entries = table(name, &behind, format, &Request::default());
    let model = entries.and_then(|entries| {
        let beside = joined(entries, options.table(name, before + lines(text))?);
        model_beside(name, &of_robot, Format::Urdf, beside)
    });
    complete(model, &sources)
}

/// The lines of a text, with one more: a mistake at its end may have the line behind the last one.
fn lines(text: &str) -> usize {
    text.lines().count() + 1
}

/// The path and the text of the URDF file that a table names.
fn text_named(path: &Path, file: &FileName) -> Result<(PathBuf, String), FileError> {
    let urdf = path.with_file_name(&file.path);
    let refused = |message| {
        let error = Error {
            place: file.place,
            rule: "file::named",
            message,
        };
        FileError::Mistakes(vec![mistake(&[(path, usize::MAX)], error)])
    };
    if Format::of(&urdf) != Some(Format::Urdf) {
        let message = format!(
            "`{}` is no URDF file: expected one that ends in `.urdf`",
            file.path
        );
        return Err(refused(message));
    }
    match read_text(&urdf) {
        Ok(text) => Ok((urdf, text)),
        Err(FileError::Unreadable(_, reason, _)) => {
            Err(refused(format!("`{}` cannot be read: {reason}", file.path)))
        }
        Err(error) => Err(error),
    }
}

/// The text that has the joints of a robot, and its format: that of a file, or of the URDF file that it names.
#[doc(hidden)]
pub fn text_of_joints(path: &Path) -> Option<(String, Format)> {
    let (text, format) = (read_text(path).ok()?, Format::of(path)?);
    match file_named(&text, format) {
        Some(file) => Some((text_named(path, &file).ok()?.1, Format::Urdf)),
        None => Some((text, format)),
    }
}

/// The model with nothing in it that is neglected, or all mistakes with their places.
fn complete(
    model: Result<Model, Vec<Error>>,
    sources: &[(&Path, usize)],
) -> Result<Model, FileError> {
    let model = model.and_then(|model| without_neglected(model).map_err(|error| vec![error]));
    model.map_err(|errors| {
        let mistakes = errors.into_iter().map(|error| mistake(sources, error));
        FileError::Mistakes(mistakes.collect())
    })
}

fn without_neglected(mut model: Model) -> Result<Model, Error> {
    if let Some((share, place)) = &model.neglect {
        let neglected = neglect(&model.robot, share.to_f64(&[]));
        model.robot = neglected.map_err(|refused| Error {
            place: *place,
            rule: "neglected_too_much",
            message: refused.to_string(),
        })?;
    }
    Ok(model)
}

/// The text of a file that is no longer than a robot's may be.
///
/// # Errors
///
/// [`FileError::Unreadable`], and a mistake where the bytes are no text.
#[doc(hidden)]
pub fn read_text(path: &Path) -> Result<String, FileError> {
    let bytes = bytes(path, MOST_BYTES).map_err(|error| {
        FileError::Unreadable(path.to_owned(), error.to_string(), error.raw_os_error())
    })?;
    text(bytes).map_err(|error| FileError::Mistakes(vec![mistake(&[(path, usize::MAX)], error)]))
}

/// A mistake with its place in one of some files, each of so many lines; behind them are the options, of which the
/// functions are the first line.
fn mistake(sources: &[(&Path, usize)], error: Error) -> FileMistake {
    let (mut line, column) = match error.place {
        Place::File { line, column } => (line, column),
        Place::Tokens { .. } => (1, 1),
    };
    let mut file = None;
    for (path, lines) in sources {
        if line <= *lines {
            file = Some(path.to_path_buf());
            break;
        }
        line -= lines;
    }
    if file.is_none() {
        line = (line - 1).max(1);
    }
    FileMistake {
        file,
        line,
        column,
        rule: error.rule,
        message: error.message,
    }
}

impl RuntimeRobot {
    /// The robot of a file: a table in TOML, in the macro's words, or in JSON, or a URDF file. A table may name a URDF file in
    /// its folder, `file = "panda.urdf"`, with entries beside it. The functions of the robot are those that
    /// the options name, or else the file, or else those of a table that names none. [`warnings`](RuntimeRobot::warnings)
    /// has what was rounded.
    ///
    /// ```no_run
    /// # mod robot_dynamics {
    /// # pub use dynamics_evaluation as evaluation;
    /// # }
    /// use robot_dynamics::evaluation::{ReadOptions, RuntimeRobot};
    ///
    /// let options = ReadOptions::new()
    ///     .chain(["panda_link0", "panda_link8"])
    ///     .entries("gravity = [0, 0, -9.81]");
    /// let panda = RuntimeRobot::from_file("panda.urdf", &options)?;
    /// # Ok::<(), robot_dynamics::evaluation::FileError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`FileError`], with all mistakes of the file and of the options.
    pub fn from_file(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Self, FileError> {
        let path = path.as_ref();
        RuntimeRobot::of_model(read_file(path, options)?, path)
    }

    /// The robot of a table in TOML, as [`from_file`](RuntimeRobot::from_file) reads it.
    ///
    /// # Errors
    ///
    /// [`FileError`], with all mistakes of the text, which is the file `TOML` in messages, and of the options.
    pub fn from_toml(text: &str, options: &ReadOptions) -> Result<Self, FileError> {
        let path = Path::new(TEXT);
        RuntimeRobot::of_model(read(path, text, Format::Toml, options)?, path)
    }

    fn of_model(model: Model, path: &Path) -> Result<Self, FileError> {
        let requests = model.requests.into_iter().map(|(request, _)| request);
        let arm = RuntimeRobot::new(model.robot, requests);
        let arm = arm.map_err(|error| FileError::Build(path.to_owned(), error))?;
        let warnings = model.warnings.iter();
        Ok(arm.with_warnings(
            warnings
                .map(|told| told.message.trim().to_owned())
                .collect(),
        ))
    }
}
