//! Functions of a robot as source code.

use std::sync::Arc;

use dynamics_codegen::Model;
use dynamics_export::{CNumbers, Error, Language, Options, files};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Proven, Request};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

use crate::description::Description;
use crate::robot::Arm;

impl Arm {
    /// The programs of functions: those of the robot are kept, others are derived anew.
    fn programs(&self, py: Python<'_>, requests: &[Request]) -> PyResult<Vec<(Request, Proven)>> {
        let mut programs = Vec::with_capacity(requests.len());
        for request in requests {
            let mut functions = self.description.functions();
            if let Some((place, _)) = functions.find(|(_, known)| *known == request) {
                let derived = self.description.derived(py, place)?;
                programs.push((derived.request.clone(), derived.proven.clone()));
            } else {
                let robot = self.description.robot.clone();
                let alone = Arc::new(Description::new(robot, [request.clone()]));
                programs.extend(alone.programs(py)?);
            }
        }
        Ok(programs)
    }

    /// The functions of these names.
    fn requests(&self, functions: &[String]) -> PyResult<Vec<Request>> {
        let requests = functions.iter().map(|name| {
            let place = self.description.place(name)?;
            Ok(self.description.request(place).clone())
        });
        requests.collect()
    }
}

/// A robot with functions, as a table that requests these has it.
fn model(robot: Robot, requests: Vec<Request>) -> Model {
    Model {
        robot,
        requests: requests.into_iter().map(|of| (of, None)).collect(),
        inverses: Vec::new(),
        tests: false,
        neglect: None,
        notes: Vec::new(),
        warnings: Vec::new(),
    }
}

#[pymethods]
impl Arm {
    /// The files of functions in a language: their names and texts.
    fn source(
        &self,
        py: Python<'_>,
        language: &str,
        functions: Vec<String>,
        scalar: Option<&str>,
        sines: Option<&str>,
        project: bool,
    ) -> PyResult<Vec<(String, String)>> {
        let language = named(language)?;
        let requests = self.requests(&functions)?;
        let robot = &self.description.robot;
        let options = Options {
            of: &robot.name,
            struct_name: None,
            numbers: c_numbers(language, scalar, sines, project)?,
            is_project: project,
            leaves_out_batches: false,
        };
        let files = py.detach(|| {
            let model = model(robot.clone(), requests);
            files(language, model, &options, |_, requests| {
                Python::attach(|py| self.programs(py, requests))
            })
        });
        files.map_err(|error| match error {
            Error::Programs(error) => error,
            Error::Unwritten(messages) => PyRuntimeError::new_err(messages),
        })
    }
}

/// Words in quotation marks, as a choice.
fn choice(words: &[&str]) -> String {
    let quoted: Vec<_> = words.iter().map(|word| format!("{word:?}")).collect();
    match &quoted[..] {
        [others @ .., last] if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => quoted.concat(),
    }
}

/// The language of that word.
fn named(word: &str) -> PyResult<Language> {
    Language::named(word).ok_or_else(|| {
        let expected = choice(&Language::ALL.map(Language::name));
        PyValueError::new_err(format!("`lang` is {word:?}: expected {expected}"))
    })
}

/// The numbers of C, which alone has these words.
fn c_numbers(
    language: Language,
    scalar: Option<&str>,
    sines: Option<&str>,
    project: bool,
) -> PyResult<CNumbers> {
    let is_asked = scalar.is_some() || sines.is_some() || project;
    if is_asked && language != Language::C {
        return Err(PyValueError::new_err(
            "`scalar`, `sines` and `project` are about `lang=\"c\"`",
        ));
    }
    for (name, word, words) in [
        ("scalar", scalar, &["double", "float"][..]),
        ("sines", sines, &["libm"]),
    ] {
        if let Some(word) = word.filter(|word| !words.contains(word)) {
            let expected = choice(words);
            return Err(PyValueError::new_err(format!(
                "`{name}` is {word:?}: expected {expected}"
            )));
        }
    }
    Ok(CNumbers::new(scalar == Some("float"), sines.is_some()))
}
