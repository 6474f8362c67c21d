//! Questions about a robot's functions: formulas, operations, the page, and a check.

use std::sync::Arc;

use dynamics_export::page;
use dynamics_numeric::check::Check;
use dynamics_symbolic::Request;
use dynamics_symbolic::formula::{Budget, Format, Formulas};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::description::Description;
use crate::ready::require_values;
use crate::robot::Arm;

/// How far formulas are multiplied out before they are given up, for each term that one may have.
const PRODUCTS_FOR_EACH_TERM: usize = 30;

/// A function in the report of a check: its name, the largest error relative to its scale, and the largest that passes.
type Compared = (String, f64, f64);

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
        let programs = Description::new(robot.clone(), requests);
        let programs = Arc::new(programs).programs(py)?;
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
