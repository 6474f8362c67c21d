//! A robot file with what the command line says besides.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::ArgMatches;
use dynamics_codegen::Model;
use dynamics_codegen::files::{Format, joint_names, names_in_values};
use dynamics_evaluation::{FileError, ReadOptions, RuntimeRobot, read_file, read_text};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Proven, Request, proven_program};

use crate::failure::Failure;
use crate::progress::Progress;

/// The argument `FILE`.
pub(crate) fn file_of(given: &ArgMatches) -> &Path {
    let path = given.get_one::<PathBuf>("file").map(PathBuf::as_path);
    path.unwrap_or(Path::new(""))
}

/// A number of the command line that has a default.
pub(crate) fn count(given: &ArgMatches, name: &str) -> usize {
    given
        .get_one::<u32>(name)
        .map_or(0, |count| *count as usize)
}

/// The robot of a file, and what is asked for. The names of `--field` stand for their values.
pub(crate) fn read(path: &Path, given: &ArgMatches) -> Result<Model, Failure> {
    read_for(path, given, Vec::new())
}

/// As [`read`], of a robot whose base may move.
pub(crate) fn read_on_any_base(path: &Path, given: &ArgMatches) -> Result<Model, Failure> {
    about_links(given, &[path])?;
    read_any(path, with_values(given, path, None, "chain")?, Vec::new())
}

/// As [`read`], of which functions are needed besides.
fn read_for(path: &Path, given: &ArgMatches, needed: Vec<Function>) -> Result<Model, Failure> {
    about_links(given, &[path])?;
    read_with(path, with_values(given, path, None, "chain")?, needed)
}

/// As [`read`], the names of `--field` being fields of the robot, of which functions are needed besides.
pub(crate) fn read_with_fields(
    path: &Path,
    given: &ArgMatches,
    needed: Vec<Function>,
) -> Result<Model, Failure> {
    about_links(given, &[path])?;
    let names = fields(given)?.into_iter().map(|(name, _)| name);
    let options = options(given, path, None, "chain")?.fields(names);
    read_with(path, options, needed)
}

/// The robot of the argument `FILE` and that of another one, with the same settings. A joint that only one
/// of the files has is locked or left out there.
pub(crate) fn read_both(other: &Path, given: &ArgMatches) -> Result<[Model; 2], Failure> {
    let path = file_of(given);
    let chain_of_other = if given.contains_id("against-chain") {
        "against-chain"
    } else {
        "chain"
    };
    about_links(given, &[path, other])?;
    let read = |path: &Path, other: &Path, chain: &str| {
        let options = with_values(given, path, Some(other), chain)?;
        read_with(path, options, Vec::new())
    };
    Ok([
        read(path, other, "chain")?,
        read(other, path, chain_of_other)?,
    ])
}

/// Whether the options that are about trees of links have a file that is one.
fn about_links(given: &ArgMatches, paths: &[&Path]) -> Result<(), Failure> {
    let mut formats = paths.iter().map(|path| Format::of(path));
    if formats.any(|format| !matches!(format, Some(Format::Toml | Format::Json))) {
        return Ok(());
    }
    let is_given = |option: &&str| matches!(given.try_contains_id(option), Ok(true));
    let mut options = ["chain", "ignore", "round-angles", "base"].into_iter();
    options.find(is_given).map_or(Ok(()), |option| {
        Err(Failure::of_the_command_line(format!(
            "`--{option}` is about a URDF file, a tree of links: {} is a table",
            paths[0].display()
        )))
    })
}

/// The model of a file, of which functions are needed besides those that are asked for. Its base must stand.
fn read_with(path: &Path, options: ReadOptions, needed: Vec<Function>) -> Result<Model, Failure> {
    let model = read_any(path, options, needed)?;
    if model.robot.freedoms().has_base() {
        let message = format!(
            "{}: the base moves, which this command does not know: `check`, `measure`, `simulate` and `generate` do",
            path.display()
        );
        return Err(Failure::after(String::new(), message));
    }
    Ok(model)
}

/// The same on any base.
fn read_any(path: &Path, options: ReadOptions, needed: Vec<Function>) -> Result<Model, Failure> {
    read_file(path, &options.for_command(needed)).map_err(|error| match &error {
        // A mistake without a file is one of the command line.
        FileError::Mistakes(mistakes) if mistakes.iter().all(|mistake| mistake.file.is_none()) => {
            Failure::of_the_command_line(&error)
        }
        FileError::Mistakes(mistakes) => Failure::of_mistakes(&error, mistakes.clone()),
        _ => Failure::from(error),
    })
}

/// The functions that a model asks for but `taylor_series`, which is no program over numbers: a remark says so.
pub(crate) fn requests(model: &Model) -> Result<Vec<Request>, Failure> {
    const LEFT_OUT: &str =
        "`taylor_series` is left out: `generate --lang rust` and the macro write it";
    let series = Request::from(Function::TaylorSeries);
    let requests = model.requests.iter().map(|(request, _)| request);
    let others: Vec<_> = requests
        .filter(|request| **request != series)
        .cloned()
        .collect();
    if others.is_empty() {
        let message = format!("{LEFT_OUT}, and nothing else is asked for");
        return Err(Failure::after(String::new(), message));
    }
    if others.len() < model.requests.len() {
        let _ = writeln!(std::io::stderr(), "{LEFT_OUT}");
    }
    Ok(others)
}

/// The words of an option.
fn words(given: &ArgMatches, option: &str) -> Vec<String> {
    let words = given.try_get_many::<String>(option).ok().flatten();
    let trimmed = words.into_iter().flatten().map(|word| word.trim());
    trimmed.map(str::to_owned).collect()
}

/// Names of the joints in a file; empty if it cannot be read, which is reported elsewhere.
fn joints_of(path: &Path) -> Vec<String> {
    let text = read_text(path).unwrap_or_default();
    Format::of(path).map_or(Vec::new(), |format| joint_names(&text, format))
}

/// As [`options`], with the names of `--field` bound to their values.
fn with_values(
    given: &ArgMatches,
    path: &Path,
    other: Option<&Path>,
    chain: &str,
) -> Result<ReadOptions, Failure> {
    let options = options(given, path, other, chain)?;
    Ok(options.entries(&values(given, path, other)?))
}

/// The names and values of `--field`, as a file binds them. A name must occur in the file, or in the other one if there
/// are two; only those of the file itself are bound.
fn values(given: &ArgMatches, path: &Path, other: Option<&Path>) -> Result<String, Failure> {
    let mut text = String::new();
    for (name, value) in assignments(given, FIELD)? {
        if has_name(path, &name) {
            let _ = writeln!(text, "let.{name:?} = {value:?}");
        } else if !other.is_some_and(|other| has_name(other, &name)) {
            let message = format!(
                "`--field {name}={value}`: no value in {} has the name `{name}`",
                path.display()
            );
            return Err(Failure::of_the_command_line(message));
        }
    }
    Ok(text)
}

/// Whether a value of the file uses the name. A file that cannot be read, which is reported elsewhere, counts as using it.
fn has_name(path: &Path, name: &str) -> bool {
    match (read_text(path), Format::of(path)) {
        (Ok(text), Some(format)) => names_in_values(&text, format).contains(name),
        _ => true,
    }
}

/// The options of the command line about a file. If there are two files, joints that only the other one
/// has are left out.
fn options(
    given: &ArgMatches,
    path: &Path,
    other: Option<&Path>,
    chain: &str,
) -> Result<ReadOptions, Failure> {
    let elsewhere = other.map(|other| (joints_of(path), joints_of(other)));
    let is_meant = |joint: &str| match &elsewhere {
        Some((here, there)) => {
            let has = |names: &[String]| names.iter().any(|name| name == joint);
            // A table has no joints beside a chain, of which `rest` would be all.
            let is_rest = joint == "rest" && Format::of(path) != Some(Format::Urdf);
            has(here) || !(has(there) || is_rest)
        }
        None => true,
    };
    let mut ignore = words(given, "ignore");
    ignore.retain(|joint| is_meant(joint));
    report_missing(given, path)?;
    let mut options = ReadOptions::new().entries(&entries(given, is_meant)?);
    if let Some(links) = self::chain(given, chain)? {
        options = options.chain(links);
    }
    if let Ok(Some(within)) = given.try_get_one::<f64>("round-angles") {
        options = options.round_angles(*within);
    }
    Ok(options.ignore(ignore))
}

/// Reports that a URDF file is without gravity. A file without joints has a mistake of its own, which is reported when it
/// is read.
fn report_missing(given: &ArgMatches, path: &Path) -> Result<(), Failure> {
    let is_urdf = Format::of(path) == Some(Format::Urdf);
    if !is_urdf || !words(given, "gravity").is_empty() || joints_of(path).is_empty() {
        return Ok(());
    }
    Err(Failure::of_the_command_line(format!(
        "{} is a tree of links: expected `--gravity X,Y,Z`, such as `--gravity 0,0,-9.81` where z of the first link \
         points up",
        path.display()
    )))
}

/// The fields of `--field NAME=VALUE` with their values as numbers.
pub(crate) fn fields(given: &ArgMatches) -> Result<Vec<(String, f64)>, Failure> {
    let number = |(name, value): (String, String)| match value.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok((name, number)),
        _ => Err(no_assignment(FIELD, &format!("{name}={value}"))),
    };
    assignments(given, FIELD)?.into_iter().map(number).collect()
}

/// An option that gives something to a name, and what is expected of it.
type Assigning = (&'static str, &'static str);
const FIELD: Assigning = ("field", "NAME=NUMBER, for example load=2.5");
const LOCK: Assigning = ("lock", "JOINT=POSITION, for example elbow=0.3");

/// The names and values of such an option, each name once.
fn assignments(given: &ArgMatches, what: Assigning) -> Result<Vec<(String, String)>, Failure> {
    let mut read: Vec<(String, String)> = Vec::new();
    for word in words(given, what.0) {
        let parts = word
            .split_once('=')
            .ok_or_else(|| no_assignment(what, &word))?;
        let (name, value) = (parts.0.trim(), parts.1.trim());
        if read.iter().any(|(other, _)| other == name) {
            let message = format!("`--{} {word}`: `{name}` has a value already", what.0);
            return Err(Failure::of_the_command_line(message));
        }
        read.push((name.to_owned(), value.to_owned()));
    }
    Ok(read)
}

fn no_assignment((option, expected): Assigning, found: &str) -> Failure {
    Failure::of_the_command_line(format!("`--{option} {found}`: expected {expected}"))
}

/// The link at which the robot begins and its tips, where an option names them.
fn chain(given: &ArgMatches, option: &str) -> Result<Option<Vec<String>>, Failure> {
    let links = words(given, option);
    if links.contains(&String::new()) {
        let message = format!("`--{option} {}`: expected BASE,TIP", links.join(","));
        return Err(Failure::of_the_command_line(message));
    }
    Ok((!links.is_empty()).then_some(links))
}

/// The entries that take the place of those of the file, in its words.
fn entries(given: &ArgMatches, is_meant: impl Fn(&str) -> bool) -> Result<String, Failure> {
    let mut text = String::new();
    for key in ["gravity", "functions", "allow"] {
        let words = words(given, key);
        let is_vector = key != "gravity" || words.len() == 3;
        if !words.is_empty() && (!is_vector || words.contains(&String::new())) {
            let expected = match key {
                "gravity" => "X,Y,Z, three numbers between commas, for example 0,0,-9.81",
                _ => "names between commas",
            };
            let message = format!("`--{key} {}`: expected {expected}", words.join(","));
            return Err(Failure::of_the_command_line(message));
        }
        if !words.is_empty() {
            let words: Vec<_> = words.iter().map(|word| format!("{word:?}")).collect();
            let _ = writeln!(text, "{key} = [{}]", words.join(", "));
        }
    }
    if let Ok(Some(base)) = given.try_get_one::<String>("base") {
        let _ = writeln!(text, "base = {base:?}");
    }
    let mut locks = Vec::new();
    for (joint, position) in assignments(given, LOCK)? {
        if is_meant(&joint) {
            locks.push(format!("{joint:?} = {position:?}"));
        }
    }
    if !locks.is_empty() {
        let _ = writeln!(text, "lock = {{ {} }}", locks.join(", "));
    }
    Ok(text)
}

/// Derives and proves functions of a file's robot.
pub(crate) fn programs(
    path: &Path,
    robot: &Robot,
    requests: &[Request],
) -> Result<Vec<(Request, Proven)>, Failure> {
    let progress = Progress::new(requests.len());
    let mut programs = Vec::with_capacity(requests.len());
    for (index, request) in requests.iter().enumerate() {
        progress.doing(request.name());
        let proven = proven_program(robot, request);
        let program = proven.map_err(|error| Failure::of_file(path, error))?;
        programs.push((robot.request(request.clone()), program));
        progress.done(index + 1);
    }
    Ok(programs)
}

/// The robot with functions.
pub(crate) fn arm(
    path: &Path,
    robot: &Robot,
    requests: &[Request],
) -> Result<RuntimeRobot, Failure> {
    let programs = programs(path, robot, requests)?;
    let arm = RuntimeRobot::of_programs(robot.clone(), &programs);
    arm.map_err(|error| Failure::of_file(path, error))
}

/// The robot of a file on any base, with single functions.
pub(crate) fn robot_with(
    given: &ArgMatches,
    functions: impl IntoIterator<Item = Function>,
) -> Result<RuntimeRobot, Failure> {
    let path = file_of(given);
    let needed: Vec<_> = functions.into_iter().collect();
    let requests: Vec<_> = needed.iter().copied().map(Request::from).collect();
    about_links(given, &[path])?;
    let model = read_any(path, with_values(given, path, None, "chain")?, needed)?;
    arm(path, &model.robot, &requests)
}

/// The robot of a file with single functions.
pub(crate) fn arm_with(
    given: &ArgMatches,
    functions: impl IntoIterator<Item = Function>,
) -> Result<RuntimeRobot, Failure> {
    let path = file_of(given);
    let needed: Vec<_> = functions.into_iter().collect();
    let requests: Vec<_> = needed.iter().copied().map(Request::from).collect();
    arm(path, &read_for(path, given, needed)?.robot, &requests)
}
