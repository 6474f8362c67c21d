//! The functions as source code.

use std::path::Path;

use dynamics_codegen::Model;
use dynamics_symbolic::emit::{
    CNumbers, c_project, c_source_in, casadi_requests, casadi_source, inverse_in_c,
    inverse_in_javascript, javascript_module, matlab_files, python_module, python_module_name,
    snake_case,
};
use dynamics_symbolic::proven_plan;

use crate::arguments::{FileOptions, Generate};
use crate::failure::Failure;
use crate::load::{programs, read_with_names, requests};
use crate::progress::Progress;
use crate::write::{make_folder, not_over_what_is_read, write};

/// Writes the files, and says which.
pub(crate) fn run(given: &Generate) -> Result<String, Failure> {
    let FileOptions { path, name, .. } = &given.robot.file;
    not_over_what_is_read([path], [&Some(given.out.clone()), &None])?;
    let c = OfC {
        numbers: c_numbers(given)?,
        is_project: given.project,
    };
    let mut model = read_with_names(&given.robot)?;
    let files = match given.lang.as_str() {
        "rust" => vec![rust(path, model, name.as_deref())?],
        language => {
            let mut inverses = inverses(language, path, &mut model)?;
            // A file of inverse kinematics alone.
            if inverses.is_empty() || !model.requests.is_empty() {
                inverses.splice(0..0, other(language, c, path, &model)?);
            }
            inverses
        }
    };
    make_folder(&given.out)?;
    let contents = files.into_iter();
    let placed: Vec<_> = contents
        .map(|(name, text)| (given.out.join(name), text))
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
fn c_numbers(given: &Generate) -> Result<CNumbers, Failure> {
    let (scalar, sines) = (&given.scalar, &given.sines);
    let is_c = given.lang == "c";
    for (option, word) in [("scalar", scalar), ("sines", sines)] {
        if let (Some(word), false) = (word, is_c) {
            return Err(Failure::of_the_command_line(format!(
                "`--{option} {word}` is about `--lang c`: Rust's functions take any scalar, and numbers of the other \
                 languages are doubles"
            )));
        }
    }
    if given.project && !is_c {
        return Err(Failure::of_the_command_line(
            "`--project` is about `--lang c`: it writes what C++ and CMake need",
        ));
    }
    Ok(CNumbers::new(
        scalar.as_deref() == Some("float"),
        sines.is_some(),
    ))
}

/// Names and texts of the files of inverse kinematics in closed form, in the languages that have them: they are no longer
/// requested then.
fn inverses(
    language: &str,
    path: &Path,
    model: &mut Model,
) -> Result<Vec<(String, String)>, Failure> {
    if model.inverses.is_empty() || !matches!(language, "c" | "js") {
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
        "c" => inverse_in_c(robot, &plans).to_vec(),
        _ => vec![inverse_in_javascript(robot, &plans)],
    })
}

/// Names and texts of the files in another language.
fn other(
    language: &str,
    c: OfC,
    path: &Path,
    model: &Model,
) -> Result<Vec<(String, String)>, Failure> {
    let robot = &model.robot;
    let requests = requests(model)?;
    if language == "casadi" {
        let programs = programs(path, robot, &casadi_requests(robot, &requests))?;
        let source = casadi_source(robot, &requests, &programs);
        return Ok(vec![(source.name, source.text)]);
    }
    let programs = programs(path, robot, &requests)?;
    let name = snake_case(&robot.name);
    Ok(match language {
        "c" => {
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
        "python" => vec![(
            format!("{}.py", python_module_name(robot)),
            python_module(robot, &programs),
        )],
        "matlab" => matlab_files(robot, &programs),
        _ => vec![(format!("{name}.mjs"), javascript_module(robot, &programs))],
    })
}
