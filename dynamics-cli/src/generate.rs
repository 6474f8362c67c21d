//! The functions as source code.

use std::path::{Path, PathBuf};

use clap::ArgMatches;
use dynamics_codegen::Model;
use dynamics_symbolic::emit::{
    CNumbers, c_project, c_source_in, casadi_requests, casadi_source, inverse_in_c,
    inverse_in_javascript, javascript_module, matlab_files, python_module, python_module_name,
    snake_case,
};
use dynamics_symbolic::proven_plan;

use crate::failure::Failure;
use crate::load::{file_of, programs, read_with_names, requests};
use crate::progress::Progress;
use crate::write::{make_folder, write};

/// Writes the files, and says which.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let path = file_of(given);
    let c = OfC {
        numbers: c_numbers(given)?,
        is_project: given.get_flag("project"),
    };
    let mut model = read_with_names(path, given)?;
    let files = match given.get_one::<String>("lang").map(String::as_str) {
        Some("rust") => {
            let name = given.get_one::<String>("name");
            vec![rust(path, model, name.map(String::as_str))?]
        }
        language => {
            let mut inverses = inverses(language, path, &mut model)?;
            // A file of inverse kinematics alone.
            if inverses.is_empty() || !model.requests.is_empty() {
                inverses.splice(0..0, other(language, c, path, &model)?);
            }
            inverses
        }
    };
    let out = given.get_one::<PathBuf>("out");
    let folder = out.map_or(Path::new("."), PathBuf::as_path);
    make_folder(folder)?;
    let contents = files.into_iter();
    let placed: Vec<_> = contents
        .map(|(name, text)| (folder.join(name), text))
        .collect();
    write(&placed)?;
    let names = placed
        .iter()
        .map(|(path, _)| format!("{}\n", path.display()));
    Ok(names.collect())
}

/// The expansion of the macro.
fn rust(path: &Path, model: Model, name: Option<&str>) -> Result<(String, String), Failure> {
    let progress = Progress::new(1);
    progress.doing("deriving and proving the functions");
    let of_file = path.file_name().unwrap_or_default().to_string_lossy();
    let source = dynamics_cli::rust::source(&of_file, model, name);
    drop(progress);
    source.map_err(|messages| Failure::of_file(path, messages))
}

/// The options of C.
struct OfC {
    numbers: CNumbers,
    /// Whether a header for C++, a file for CMake and a test are written too.
    is_project: bool,
}

/// The numbers of C. `--scalar`, `--sines` and `--project` are of no other language.
fn c_numbers(given: &ArgMatches) -> Result<CNumbers, Failure> {
    let word = |option: &str| given.get_one::<String>(option).map(String::as_str);
    let (scalar, sines) = (word("scalar"), word("sines"));
    let language = word("lang").unwrap_or_default();
    for (option, given) in [("scalar", scalar), ("sines", sines)] {
        if let (Some(word), true) = (given, language != "c") {
            return Err(Failure::of_the_command_line(format!(
                "`--{option} {word}` is about `--lang c`: Rust's functions take any scalar, and numbers of the other \
                 languages are doubles"
            )));
        }
    }
    if given.get_flag("project") && language != "c" {
        return Err(Failure::of_the_command_line(
            "`--project` is about `--lang c`: it writes what C++ and CMake need",
        ));
    }
    Ok(CNumbers::new(scalar == Some("float"), sines.is_some()))
}

/// Names and texts of the files of inverse kinematics in closed form, in the languages that have them: they are no longer
/// requested then.
fn inverses(
    language: Option<&str>,
    path: &Path,
    model: &mut Model,
) -> Result<Vec<(String, String)>, Failure> {
    if model.inverses.is_empty() || !matches!(language, Some("c" | "js")) {
        return Ok(Vec::new());
    }
    let robot = &model.robot;
    let mut plans = Vec::new();
    for (frame, _) in core::mem::take(&mut model.inverses) {
        let plan = proven_plan(robot, frame).map_err(|why| {
            let message = format!(
                "the inverse kinematics of this arm have no closed form, because {why}; `robot-dynamics reach` solves \
                 numerically"
            );
            Failure::of_file(path, message)
        })?;
        plans.push((frame.map(|frame| robot.frames[frame].name.as_str()), plan));
    }
    Ok(match language {
        Some("c") => inverse_in_c(robot, &plans).to_vec(),
        _ => vec![inverse_in_javascript(robot, &plans)],
    })
}

/// Names and texts of the files in another language.
fn other(
    language: Option<&str>,
    c: OfC,
    path: &Path,
    model: &Model,
) -> Result<Vec<(String, String)>, Failure> {
    let robot = &model.robot;
    let requests = requests(model)?;
    if language == Some("casadi") {
        let programs = programs(path, robot, &casadi_requests(robot, &requests))?;
        let source = casadi_source(robot, &requests, &programs);
        return Ok(vec![(source.name, source.text)]);
    }
    let programs = programs(path, robot, &requests)?;
    let name = snake_case(&robot.name);
    Ok(match language {
        Some("c") => {
            let source = c_source_in(robot, &programs, c.numbers);
            let mut files = vec![
                (format!("{name}.h"), source.header),
                (format!("{name}.c"), source.source),
            ];
            if c.is_project {
                files.extend(c_project(robot, &programs, c.numbers));
            }
            files
        }
        Some("python") => vec![(
            format!("{}.py", python_module_name(robot)),
            python_module(robot, &programs),
        )],
        Some("matlab") => matlab_files(robot, &programs),
        _ => vec![(format!("{name}.mjs"), javascript_module(robot, &programs))],
    })
}
