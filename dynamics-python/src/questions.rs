//! Questions about a robot's functions: formulas, operations, source code, and a check.

use std::sync::Arc;

use dynamics_cli::page;
use dynamics_cli::rust::source;
use dynamics_codegen::Model;
use dynamics_runtime::check::Check;
use dynamics_symbolic::emit::{
    CNumbers, c_project, c_source_in, casadi_requests, casadi_source, javascript_module,
    matlab_files, python_module, snake_case,
};
use dynamics_symbolic::formula::{Budget, Format, Formulas};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Proven, Request};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

use crate::description::Description;
use crate::function::require_values;
use crate::robot::Arm;

/// How far formulas are multiplied out before they are given up, for each term that one may have.
const PRODUCTS_FOR_EACH_TERM: usize = 30;

/// A function in the report of a check: its name, the largest error relative to its scale, and the largest that passes.
type Compared = (String, f64, f64);

impl Arm {
    /// The expansion of the macro, which derives the functions anew.
    fn rust(&self, py: Python<'_>, functions: &[String]) -> PyResult<(String, String)> {
        let requests = self.requests(functions)?;
        let robot = self.description.robot.clone();
        let source = py.detach(|| {
            let name = robot.name.clone();
            let model = Model {
                robot,
                requests: requests.into_iter().map(|of| (of, None)).collect(),
                inverses: Vec::new(),
                tests: false,
                neglect: None,
                notes: Vec::new(),
                warnings: Vec::new(),
            };
            source(&name, model, None)
        });
        source.map_err(PyRuntimeError::new_err)
    }

    /// The file for CasADi, which has derivatives that nobody has requested by name.
    fn casadi(&self, py: Python<'_>, functions: &[String]) -> PyResult<(String, String)> {
        let requests = self.requests(functions)?;
        let robot = &self.description.robot;
        let programs = derived_anew(py, robot, casadi_requests(robot, &requests))?;
        let source = casadi_source(robot, &requests, &programs);
        Ok((source.name, source.text))
    }

    fn requests(&self, functions: &[String]) -> PyResult<Vec<Request>> {
        let requests = functions.iter().map(|name| {
            let place = self.description.place(name)?;
            Ok(self.description.request(place).clone())
        });
        requests.collect()
    }
}

/// Programs of functions, whether these were requested for a robot or not.
fn derived_anew(
    py: Python<'_>,
    robot: &Robot,
    requests: Vec<Request>,
) -> PyResult<Vec<(Request, Proven)>> {
    let places = 0..requests.len();
    let description = Arc::new(Description::new(robot.clone(), requests));
    let programs = places.map(|place| {
        let derived = description.derived(py, place)?;
        Ok((derived.request.clone(), derived.proven.clone()))
    });
    programs.collect()
}

#[pymethods]
impl Arm {
    /// The page of the robot: a file that shows it in motion.
    fn page(&self, py: Python<'_>) -> PyResult<String> {
        let mut robot = self.description.robot.clone();
        require_values(&robot.fields, &self.fields)?;
        let names = robot.fields.iter().cloned();
        let fields: Vec<_> = names.zip(self.fields.iter().copied()).collect();
        let poses = page::shown_poses(&mut robot);
        let requests = page::FUNCTIONS.map(Request::from).into_iter();
        let requests: Vec<_> = requests.chain(poses.iter().cloned()).collect();
        let programs = derived_anew(py, &robot, requests)?;
        let start = page::Start::default();
        Ok(page::Page::new(&robot, &programs, &poses, &fields, &start).html)
    }

    /// How many products, sums, quotients, pairs of sine and cosine, and exponentials a function takes.
    fn operations(&self, py: Python<'_>, function: &str) -> PyResult<(u32, u32, u32, u32, u32)> {
        let counted = self.derived(py, function)?.proven.program.operations();
        Ok((
            counted.multiplications,
            counted.additions,
            counted.divisions,
            counted.sin_cos,
            counted.exponentials,
        ))
    }

    /// The formulas of a function, one a line, and the lines that say what their letters mean.
    fn formulas(
        &self,
        py: Python<'_>,
        function: &str,
        format: &str,
        terms: usize,
    ) -> PyResult<(Vec<String>, Vec<String>)> {
        let format = match format {
            "text" => Format::Text,
            "latex" => Format::Latex,
            "mathml" => Format::MathMl,
            _ => {
                return Err(PyValueError::new_err(format!(
                    "`format` is {format:?}: expected \"text\", \"latex\" or \"mathml\""
                )));
            }
        };
        let derived = self.derived(py, function)?;
        let budget = Budget {
            terms,
            products: PRODUCTS_FOR_EACH_TERM.saturating_mul(terms),
        };
        let (parts, program) = (derived.request.parts(), &derived.proven.program);
        let formulas = Formulas::new(&self.description.robot, parts, program, budget);
        let shown = formulas.shown(format, terms);
        if shown.is_empty() {
            return Err(PyValueError::new_err(format!(
                "`{function}` has no formulas: it solves equations step by step, or its values have no letters"
            )));
        }
        let too_long = shown.iter().filter_map(|one| one.formula.as_ref().err());
        if let Some(most) = too_long.map(|too_long| too_long.terms).max() {
            return Err(PyValueError::new_err(format!(
                "formulas of `{function}` have more than {terms} terms: `terms={most}` allows as many as are known of"
            )));
        }
        let equations = formulas.equations(terms).into_iter();
        let equations = equations.map(|equation| match format {
            Format::Text => equation.text,
            Format::Latex => equation.latex,
            Format::MathMl => equation.mathml,
        });
        Ok((equations.collect(), formulas.legend(terms)))
    }

    /// The files of functions in another language: their names and texts.
    fn source(
        &self,
        py: Python<'_>,
        language: &str,
        functions: Vec<String>,
        scalar: Option<&str>,
        sines: Option<&str>,
        project: bool,
    ) -> PyResult<Vec<(String, String)>> {
        let numbers = c_numbers(language, scalar, sines, project)?;
        let programs = |names: &[String]| -> PyResult<Vec<(Request, Proven)>> {
            let derived = names.iter().map(|name| self.derived(py, name));
            derived
                .map(|derived| derived.map(|of| (of.request.clone(), of.proven.clone())))
                .collect()
        };
        let robot = &self.description.robot;
        let name = snake_case(&robot.name);
        let file = |ending: &str, text: String| (format!("{name}.{ending}"), text);
        Ok(match language {
            "c" => {
                let programs = programs(&functions)?;
                let source = c_source_in(robot, &programs, numbers);
                let mut files = vec![file("h", source.header), file("c", source.source)];
                if project {
                    files.extend(c_project(robot, &programs, numbers));
                }
                files
            }
            "js" => vec![file(
                "mjs",
                javascript_module(robot, &programs(&functions)?),
            )],
            "rust" => vec![self.rust(py, &functions)?],
            "casadi" => vec![self.casadi(py, &functions)?],
            "matlab" => matlab_files(robot, &programs(&functions)?),
            "python" => vec![file("py", python_module(robot, &programs(&functions)?))],
            _ => {
                return Err(PyValueError::new_err(format!(
                    "`lang` is {language:?}: expected \"rust\", \"c\", \"js\", \"matlab\", \"python\" or \
                     \"casadi\""
                )));
            }
        })
    }

    /// Compares the functions with Newton-Euler at so many random states. The text of the report, whether all passed, and
    /// each function.
    fn check(&self, py: Python<'_>, samples: usize) -> PyResult<(String, bool, Vec<Compared>)> {
        let robot = self.all_functions(py)?;
        let report = py.detach(|| Check::new().samples(samples).run_any(&*robot));
        let functions = report.functions.iter().map(|of| {
            let frame = of.frame.as_ref().map(|frame| format!("_{frame}"));
            let name = of.function.to_owned() + &frame.unwrap_or_default();
            (name, of.error, of.tolerance)
        });
        let functions = functions.collect();
        Ok((report.to_string(), report.is_ok(), functions))
    }
}

/// The numbers of C, which alone has these words.
fn c_numbers(
    language: &str,
    scalar: Option<&str>,
    sines: Option<&str>,
    project: bool,
) -> PyResult<CNumbers> {
    let is_asked = scalar.is_some() || sines.is_some() || project;
    if is_asked && language != "c" {
        return Err(PyValueError::new_err(
            "`scalar`, `sines` and `project` are about `lang=\"c\"`",
        ));
    }
    for (name, word, words) in [
        ("scalar", scalar, &["double", "float"][..]),
        ("sines", sines, &["libm"]),
    ] {
        if let Some(word) = word.filter(|word| !words.contains(word)) {
            let expected: Vec<_> = words.iter().map(|word| format!("{word:?}")).collect();
            let expected = expected.join(" or ");
            return Err(PyValueError::new_err(format!(
                "`{name}` is {word:?}: expected {expected}"
            )));
        }
    }
    Ok(CNumbers::new(scalar == Some("float"), sines.is_some()))
}
