//! The robot that Python holds.

use std::path::PathBuf;
use std::sync::Arc;

use dynamics_evaluation::{ReadOptions, read_text};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::description::Description;
use crate::errors;
use crate::function::Function;

/// A robot that was read, with values of its fields.
#[pyclass(frozen, module = "robot_dynamics._native")]
pub(crate) struct Arm {
    description: Arc<Description>,
    fields: Arc<[f64]>,
}

/// The text of a file.
#[pyfunction]
pub(crate) fn text_of(py: Python<'_>, path: PathBuf) -> PyResult<String> {
    read_text(&path).map_err(|error| errors::of_file(py, &error))
}

/// The values of fields that have none yet.
fn without_values(description: &Description) -> Arc<[f64]> {
    vec![f64::NAN; description.robot.fields.len()].into()
}

#[pymethods]
impl Arm {
    /// Reads the text of a file of that name, with entries in TOML and options beside it.
    #[new]
    #[pyo3(signature = (path, text, entries, functions=None, chain=None, ignore=Vec::new(), round_angles=None, fields=Vec::new()))]
    #[allow(clippy::too_many_arguments)] // They are the options of `ReadOptions`.
    fn new(
        py: Python<'_>,
        path: PathBuf,
        text: &str,
        entries: &str,
        functions: Option<Vec<String>>,
        chain: Option<Vec<String>>,
        ignore: Vec<String>,
        round_angles: Option<f64>,
        fields: Vec<String>,
    ) -> PyResult<Self> {
        let mut options = ReadOptions::new()
            .entries(entries)
            .ignore(ignore)
            .fields(fields);
        if let Some(names) = functions {
            options = options.functions(names);
        }
        if let Some(links) = chain {
            options = options.chain(links);
        }
        if let Some(within) = round_angles {
            options = options.round_angles(within);
        }
        let read = py.detach(|| Description::read(&path, text, &options));
        let description = read.map_err(|error| errors::of_file(py, &error))?;
        Ok(Arm {
            fields: without_values(&description),
            description: Arc::new(description),
        })
    }

    /// The same robot whose fields have these values.
    fn with_fields(&self, values: Vec<(String, f64)>) -> PyResult<Self> {
        let names = self.field_names();
        let mut fields = self.fields.to_vec();
        for (name, value) in values {
            let place = names.iter().position(|field| *field == name);
            let place = place.ok_or_else(|| {
                let expected = match &names[..] {
                    [] => "the robot has none".to_owned(),
                    names => format!("expected one of {}", names.join(", ")),
                };
                PyValueError::new_err(format!("no field `{name}`: {expected}"))
            })?;
            fields[place] = value;
        }
        Ok(Arm {
            description: Arc::clone(&self.description),
            fields: fields.into(),
        })
    }

    /// The name.
    #[getter]
    fn name(&self) -> &str {
        &self.description.robot.name
    }

    /// Degrees of freedom: the joints that move, and six more of a base that moves.
    #[getter]
    fn dof(&self) -> usize {
        self.description.robot.dof()
    }

    /// Names of the joints that move, from the base outwards.
    #[getter]
    fn joint_names(&self) -> Vec<String> {
        let joints = self.description.robot.joints();
        joints.map(|row| row.name.clone()).collect()
    }

    /// Least and greatest position of each joint that moves, rad or m; infinite where there is no limit.
    #[getter]
    fn joint_limits(&self) -> Vec<[f64; 2]> {
        let joints = self.description.robot.joints();
        let limits = joints.map(|row| match &row.limits {
            Some(limits) => limits.each_ref().map(|limit| limit.to_f64(&self.fields)),
            None => [f64::NEG_INFINITY, f64::INFINITY],
        });
        limits.collect()
    }

    /// Names of the fields.
    #[getter]
    fn field_names(&self) -> Vec<String> {
        let names = self.description.robot.fields.iter();
        let plain = names.map(|name| name.strip_prefix("r#").unwrap_or(name).to_owned());
        plain.collect()
    }

    /// Values of the fields, NaN of those without.
    #[getter]
    fn field_values(&self) -> Vec<f64> {
        self.fields.to_vec()
    }

    /// The functions by their names.
    #[getter]
    fn functions(&self) -> Vec<(String, Function)> {
        let functions = self.description.functions().map(|(place, request)| {
            let function = Function::new(&self.description, place, &self.fields);
            (request.name().to_owned(), function)
        });
        functions.collect()
    }
}
