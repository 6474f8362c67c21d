//! The files of a robot in a language.

use core::mem;

use dynamics_codegen::Model;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Proven, Request, proven_plan};

use crate::c::{CNumbers, c_project, c_source_in, c_source_without_batches};
use crate::casadi::{casadi_requests, casadi_source};
use crate::closed_form::{inverse_in_c, inverse_in_javascript};
use crate::javascript::javascript_module;
use crate::language::Language;
use crate::matlab::matlab_files;
use crate::names::snake_case;
use crate::python::{python_module, python_module_name};
use crate::rust;

/// Settings of the files.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options<'a> {
    /// The file of the robot, or its name, as the documentation in Rust has it.
    pub of: &'a str,
    /// The name of the struct in Rust; one that is none, and nothing, stand for that of the robot.
    pub struct_name: Option<&'a str>,
    /// The numbers of C.
    pub numbers: CNumbers,
    /// Whether C has a header for C++, a file for CMake and a test besides.
    pub is_project: bool,
    /// Whether C has no functions over columns of states.
    pub leaves_out_batches: bool,
}

/// The reason why there are no files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error<E> {
    /// Programs of functions were not derived.
    Programs(E),
    /// The model cannot be written in the language: messages, one a line.
    Unwritten(String),
}

/// The functions of a robot, each with its program.
type Programs = Vec<(Request, Proven)>;

/// Names and texts of the files of a model in a language.
///
/// `programs` derives functions of the robot and proves them. Rust asks for none: the expansion of the macro derives its own.
/// The files of a model with inverse kinematics in closed form alone are those of it; languages without it leave it out.
///
/// # Errors
///
/// The error of `programs`; or messages about functions of Rust that could not be derived, or about an arm without a closed
/// form.
pub fn files<E>(
    language: Language,
    mut model: Model,
    options: &Options<'_>,
    programs: impl FnOnce(&Robot, &[Request]) -> Result<Programs, E>,
) -> Result<Vec<(String, String)>, Error<E>> {
    if language == Language::Rust {
        let file = rust::source(options.of, model, options.struct_name);
        return Ok(vec![file.map_err(Error::Unwritten)?]);
    }
    let inverses = inverses(language, &mut model, options).map_err(Error::Unwritten)?;
    if model.requests.is_empty() && !inverses.is_empty() {
        return Ok(inverses);
    }
    let requests = model.requests.into_iter();
    let requests: Vec<_> = requests.map(|(request, _)| request).collect();
    let needed = match language {
        Language::Casadi => casadi_requests(&model.robot, &requests),
        _ => requests.clone(),
    };
    let programs = programs(&model.robot, &needed).map_err(Error::Programs)?;
    let mut files = functions(language, &model.robot, &requests, &programs, options);
    files.extend(inverses);
    Ok(files)
}

/// The files of functions.
fn functions(
    language: Language,
    robot: &Robot,
    requests: &[Request],
    programs: &[(Request, Proven)],
    options: &Options<'_>,
) -> Vec<(String, String)> {
    let ending = language.extension();
    let named = |text: String| (format!("{}.{ending}", snake_case(&robot.name)), text);
    match language {
        Language::Rust => Vec::new(),
        Language::C => {
            let write = match options.leaves_out_batches {
                true => c_source_without_batches,
                false => c_source_in,
            };
            let source = write(robot, programs, options.numbers);
            let header = (format!("{}.h", source.name), source.header);
            let mut files = vec![header, named(source.source)];
            if options.is_project {
                files.extend(c_project(robot, programs, options.numbers));
            }
            files
        }
        Language::JavaScript => vec![named(javascript_module(robot, programs))],
        Language::Python => {
            let name = format!("{}.{ending}", python_module_name(robot));
            vec![(name, python_module(robot, programs))]
        }
        Language::Matlab => matlab_files(robot, programs),
        Language::Casadi => {
            let source = casadi_source(robot, requests, programs);
            vec![(source.name, source.text)]
        }
    }
}

/// The files of inverse kinematics in closed form, which the model has no longer then.
fn inverses(
    language: Language,
    model: &mut Model,
    options: &Options<'_>,
) -> Result<Vec<(String, String)>, String> {
    let inverses = mem::take(&mut model.inverses);
    if inverses.is_empty() || !language.has_closed_forms() {
        return Ok(Vec::new());
    }
    let robot = &model.robot;
    let mut plans = Vec::new();
    for (frame, _) in inverses {
        let plan = proven_plan(robot, frame).map_err(|why| {
            format!(
                "the inverse kinematics of this arm have no closed form, because {why}; `robot-dynamics reach` solves \
                 numerically"
            )
        })?;
        plans.push((frame.map(|frame| robot.frames[frame].name.as_str()), plan));
    }
    Ok(match language {
        Language::C => inverse_in_c(robot, &plans, options.numbers).to_vec(),
        _ => vec![inverse_in_javascript(robot, &plans)],
    })
}
