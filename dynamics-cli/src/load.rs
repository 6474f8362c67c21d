//! A robot file with what the command line says besides.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::ArgMatches;
use dynamics_evaluation::{Besides, FileError, RuntimeRobot, read_file};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Proven, Request, proven_program};
use indicatif::ProgressBar;

use crate::failure::Failure;

/// The robot of the argument `FILE`, and what is asked for.
pub(crate) fn model(given: &ArgMatches) -> Result<(Robot, Vec<Request>), Failure> {
    let path = given.get_one::<PathBuf>("file").map(PathBuf::as_path);
    model_of(path.unwrap_or(Path::new("")), given)
}

/// The robot of another file, with the same settings.
pub(crate) fn model_of(path: &Path, given: &ArgMatches) -> Result<(Robot, Vec<Request>), Failure> {
    let model = read_file(path, &besides(given)?).map_err(|error| match &error {
        // A mistake without a file is one of the command line.
        FileError::Mistakes(mistakes) if mistakes.iter().all(|mistake| mistake.file.is_none()) => {
            Failure::of_the_command_line(&error)
        }
        _ => Failure::from(error),
    })?;
    let requests = model.requests.into_iter().map(|(request, _)| request);
    Ok((model.robot, requests.collect()))
}

/// What the command line says besides the file.
fn besides(given: &ArgMatches) -> Result<Besides, Failure> {
    let names = |option: &str| -> Vec<String> {
        let names = given.get_many::<String>(option).into_iter().flatten();
        names.map(|name| name.trim().to_owned()).collect()
    };
    let chain = names("chain");
    let chain = match <[String; 2]>::try_from(chain) {
        Ok(chain) => Some(chain),
        Err(none) if none.is_empty() => None,
        Err(links) => {
            let message = format!("`--chain {}`: expected BASE,TIP", links.join(","));
            return Err(Failure::of_the_command_line(message));
        }
    };
    Ok(Besides {
        entries: entries(given)?,
        chain,
        ignore: names("ignore"),
        round_angles: given.get_one::<f64>("round-angles").copied(),
    })
}

/// The entries that take the place of those of the file, in its words.
fn entries(given: &ArgMatches) -> Result<String, Failure> {
    let mut text = String::new();
    let words = |name: &str| {
        let words = given.try_get_many::<String>(name).ok().flatten();
        words.map(|words| {
            words
                .map(|word| format!("{:?}", word.trim()))
                .collect::<Vec<_>>()
        })
    };
    if let Some(gravity) = words("gravity") {
        let _ = writeln!(text, "gravity = [{}]", gravity.join(", "));
    }
    if let Some(functions) = words("functions") {
        let _ = writeln!(text, "functions = [{}]", functions.join(", "));
    }
    if let Some(locks) = given.get_many::<String>("lock") {
        let mut entries = Vec::new();
        for lock in locks {
            let Some((joint, position)) = lock.split_once('=') else {
                let message =
                    format!("`--lock {lock}`: expected JOINT=POSITION, for example elbow=0.3");
                return Err(Failure::of_the_command_line(message));
            };
            entries.push(format!("{:?} = {:?}", joint.trim(), position.trim()));
        }
        let _ = writeln!(text, "lock = {{ {} }}", entries.join(", "));
    }
    Ok(text)
}

/// Derives and proves the functions, and shows on a terminal how far it is.
pub(crate) fn programs(
    robot: &Robot,
    requests: impl IntoIterator<Item = Request>,
) -> Result<Vec<(Request, Proven)>, Failure> {
    let requests: Vec<_> = requests.into_iter().collect();
    let bar = ProgressBar::new(requests.len() as u64);
    bar.enable_steady_tick(Duration::from_millis(200));
    let mut programs = Vec::with_capacity(requests.len());
    for request in requests {
        bar.set_message(request.name().to_owned());
        let program = proven_program(robot, &request)?;
        programs.push((request, program));
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(programs)
}

/// The robot with what is asked for, `taylor_series` left out, which is no program over numbers.
pub(crate) fn arm(robot: Robot, requests: Vec<Request>) -> Result<RuntimeRobot, Failure> {
    let series = Request::One(Function::TaylorSeries);
    let requests = requests.into_iter().filter(|request| *request != series);
    let programs = programs(&robot, requests)?;
    Ok(RuntimeRobot::of_programs(robot, &programs)?)
}
