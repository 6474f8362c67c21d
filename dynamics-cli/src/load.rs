//! A robot file with what the command line says besides.

use std::collections::BTreeSet;
use std::io::Write as _;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use dynamics_codegen::Model;
use dynamics_codegen::description::Masses;
use dynamics_evaluation::{FileError, FileMistake, RuntimeRobot, read_file};
use dynamics_symbolic::function::plain;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Proven, Request, proven_program};

use crate::arguments::{FileOptions, RobotOptions};
use crate::beside::{Beside, Source, has_links};
use crate::failure::Failure;
use crate::progress::Progress;

fn source(given: &RobotOptions) -> Source<'_> {
    Source::new(&given.file, &given.functions)
}

/// The robot of a file on any base, and what is requested. The names of `--field` stand for their values.
pub(crate) fn read_on_any_base(given: &RobotOptions) -> Result<Model, Failure> {
    read(source(given).with_values()?, Vec::new())
}

/// As [`read_on_any_base`], where names that nothing binds are fields of the robot.
pub(crate) fn read_with_names(given: &RobotOptions) -> Result<Model, Failure> {
    read(source(given).with_names()?, Vec::new())
}

/// As [`read_on_any_base`], of an arm whose base must stand and whose masses nothing reads. Links of a URDF file are frames
/// of the robot where something is asked of them, as here of one that has this name.
pub(crate) fn read_on_standing_base(
    given: &FileOptions,
    frame: Option<&str>,
) -> Result<Model, Failure> {
    let beside = || {
        let beside = Source::new(given, &[]).with_values()?;
        Ok::<_, Failure>(beside.masses(Masses::Never))
    };
    let path = &given.path;
    let model = read(beside()?, Vec::new())?;
    if model.robot.freedoms().has_base() {
        let message = format!(
            "{}: the base moves, which `reach` does not know: all others do",
            path.display()
        );
        return Err(Failure::after(String::new(), message));
    }
    let Some(frame) = frame.filter(|_| has_links(path)) else {
        return Ok(model);
    };
    let mut beside = beside()?;
    let asked = format!("{}({frame:?})", Function::ForwardKinematics.name());
    beside.options = beside.options.functions([asked]);
    // If no link has the name, the frames of the robot alone are there.
    Ok(read(beside, Vec::new()).unwrap_or(model))
}

/// As [`read_on_any_base`], the names of `--field` being fields of the robot, of which functions are needed besides. A table
/// may be one of geometry.
pub(crate) fn read_with_fields(
    given: &RobotOptions,
    needed: Vec<Function>,
) -> Result<Model, Failure> {
    let beside = source(given).with_fields()?;
    read(beside.masses(Masses::IfAny), needed)
}

/// The robot of the argument `FILE` and that of another one, with the same settings, on any base. A joint that only
/// one of the files has is locked or left out there.
pub(crate) fn read_both(
    given: &RobotOptions,
    other: &Path,
    chain_of_other: &[String],
) -> Result<[Model; 2], Failure> {
    let [one, two] = Source::both(given, other, chain_of_other);
    let one = read(one.with_values()?, Vec::new())?;
    Ok([one, read(two.with_values()?, Vec::new())?])
}

/// As [`read_on_any_base`], where all links of a URDF file may be frames. A table may be one of geometry.
pub(crate) fn read_with_links(given: &RobotOptions, keeps: bool) -> Result<Model, Failure> {
    let mut beside = source(given).with_values()?;
    beside.options = beside.options.keep_links(keeps);
    read(beside.masses(Masses::IfAny), Vec::new())
}

/// The model of a file, of which functions are needed besides those that are requested. Its
/// warnings are told once.
fn read(beside: Beside, needed: Vec<Function>) -> Result<Model, Failure> {
    let path = beside.path;
    let model = read_silently(beside, needed)?;
    for warning in &model.warnings {
        let told = format!("{}: {}", path.display(), for_command(&warning.message));
        static TOLD: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
        let mut all = TOLD.lock().unwrap_or_else(PoisonError::into_inner);
        if all.insert(told.clone()) {
            let _ = writeln!(std::io::stderr(), "{told}");
        }
    }
    Ok(model)
}

/// A note, which is in the words of a call of the macro, in those of the command.
pub(crate) fn for_command(note: &str) -> String {
    note.trim().replace("`round_angles: ", "`--round-angles ")
}

fn read_silently(beside: Beside, needed: Vec<Function>) -> Result<Model, Failure> {
    let Beside {
        path,
        options,
        lines,
        keeps_names,
        name,
    } = beside;
    let model = read_file(path, &options.for_command(needed));
    let mut model = model.map_err(|error| match error {
        FileError::Mistakes(mistakes) => mistaken(mistakes, &lines),
        _ => Failure::from(error),
    })?;
    if let Some(name) = name {
        model.robot.name = name;
    }
    match model.robot.fields.is_empty() || keeps_names {
        true => Ok(model),
        false => Err(without_values(path, &model.robot.fields)),
    }
}

/// The failure of fields that the file lists, where their values are needed.
fn without_values(path: &Path, fields: &[String]) -> Failure {
    let names = fields.iter().map(|field| plain(field));
    let quoted: Vec<_> = names.clone().map(|name| format!("`{name}`")).collect();
    let options: Vec<_> = names.map(|name| format!("--field {name}=2")).collect();
    let message = format!(
        "fields have no value: {}. This command needs numbers: `{}`, for example",
        quoted.join(", "),
        options.join(" ")
    );
    Failure::of_file(path, message)
}

/// The failure of mistakes in a file and in options. A mistake without a file is one of the command line.
fn mistaken(mut mistakes: Vec<FileMistake>, lines: &[String]) -> Failure {
    for mistake in &mut mistakes {
        // Chains and joints that are left out are reported at the first line, which is empty.
        let line = mistake.line.checked_sub(2);
        let option = line.and_then(|line| lines.get(line));
        if let (None, Some(option)) = (&mistake.file, option) {
            mistake.message = format!("`{option}`: {}", mistake.message);
        }
    }
    let is_of_options = mistakes.iter().all(|mistake| mistake.file.is_none());
    let error = FileError::Mistakes(mistakes.clone());
    if is_of_options {
        Failure::of_the_command_line(&error)
    } else {
        Failure::of_mistakes(&error, mistakes)
    }
}

/// The functions that a model requests, except `taylor_series` and closed forms of inverse kinematics, which are no
/// programs over numbers: a remark says so.
pub(crate) fn requests(model: &Model) -> Result<Vec<Request>, Failure> {
    let series = Request::from(Function::TaylorSeries);
    let requests = model.requests.iter().map(|(request, _)| request);
    let others: Vec<_> = requests
        .filter(|request| **request != series)
        .cloned()
        .collect();
    let mut left_out = Vec::new();
    if others.len() < model.requests.len() {
        left_out.push("`taylor_series`");
    }
    if !model.inverses.is_empty() {
        left_out.push("`inverse_kinematics`");
    }
    let be = if left_out.len() == 1 { "is" } else { "are" };
    let names = left_out.join(" and ");
    let writers = match left_out[..] {
        ["`inverse_kinematics`"] => "`generate --lang rust`, `c` or `js` and the macro write it",
        _ => "`generate --lang rust` and the macro write it",
    };
    let remark = format!("{names} {be} left out: {writers}");
    if others.is_empty() {
        let message = format!("{remark}, and nothing else is requested");
        return Err(Failure::after(String::new(), message));
    }
    if !left_out.is_empty() {
        let _ = writeln!(std::io::stderr(), "{remark}");
    }
    Ok(others)
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
    given: &RobotOptions,
    functions: impl IntoIterator<Item = Function>,
) -> Result<RuntimeRobot, Failure> {
    let needed: Vec<_> = functions.into_iter().collect();
    let requests: Vec<_> = needed.iter().copied().map(Request::from).collect();
    let model = read(source(given).with_values()?, needed)?;
    arm(&given.file.path, &model.robot, &requests)
}
