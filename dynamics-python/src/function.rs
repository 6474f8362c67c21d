//! A function of a robot, as Python calls it.

use std::sync::{Arc, OnceLock};

use dynamics_evaluation::{Arrangement, RuntimeRobot};
use dynamics_symbolic::Request;
use dynamics_symbolic::function::plain;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::arguments::Argument;
use crate::call::{self, MOST_ARGUMENTS, SHORT};
use crate::description::{Derived, Description};
use crate::documentation;

// A function of a robot. It is derived at its first call, and kept. A documentation of the class, which the stub has,
// would take the place of the functions' own.
#[pyclass(frozen, module = "robot_dynamics")]
pub(crate) struct Function {
    description: Arc<Description>,
    place: usize,
    fields: Arc<[f64]>,
    ready: OnceLock<Ready>,
}

/// All that a call needs to know.
pub(crate) struct Ready {
    pub(crate) arm: Arc<RuntimeRobot>,
    pub(crate) name: String,
    pub(crate) arguments: Vec<Argument>,
    pub(crate) arrangement: Arrangement,
    pub(crate) entries: usize,
    /// Whether a call of one state has room for all its numbers.
    pub(crate) is_short: bool,
}

impl Function {
    pub(crate) fn new(description: &Arc<Description>, place: usize, fields: &Arc<[f64]>) -> Self {
        Function {
            description: Arc::clone(description),
            place,
            fields: Arc::clone(fields),
            ready: OnceLock::new(),
        }
    }

    /// The request as the robot answers it.
    fn request(&self) -> Request {
        let request = self.description.request(self.place);
        self.description.robot.request(request.clone())
    }

    pub(crate) fn ready(&self, py: Python<'_>) -> PyResult<&Ready> {
        if let Some(ready) = self.ready.get() {
            return Ok(ready);
        }
        let derived = self.description.derived(py, self.place)?;
        let ready = Ready::new(derived, &self.fields)?;
        Ok(self.ready.get_or_init(|| ready))
    }
}

impl Ready {
    fn new(derived: &Derived, fields: &[f64]) -> PyResult<Self> {
        let error =
            |error: dynamics_evaluation::EvaluationError| PyValueError::new_err(error.to_string());
        let mut arm = Arc::clone(&derived.arm);
        if !fields.is_empty() {
            let mut with_fields = (*arm).clone();
            with_fields.set_fields(fields).map_err(error)?;
            require_values(with_fields.field_names(), fields)?;
            arm = Arc::new(with_fields);
        }
        let name = derived.request.name();
        let moves = arm.robot().freedoms().has_base();
        let arguments = arm.arguments(name).map_err(error)?;
        let arguments = arguments.map(|(name, entries)| Argument::new(name, entries, moves));
        let arguments: Vec<_> = arguments.collect();
        let read: usize = arguments.iter().map(|of| of.entries).sum();
        let entries = arm.entries(name).map_err(error)?;
        Ok(Ready {
            is_short: arguments.len() <= MOST_ARGUMENTS && read.max(entries) <= SHORT,
            arguments,
            arrangement: arm.arrangement(name).map_err(error)?,
            entries,
            name: name.to_owned(),
            arm,
        })
    }

    /// The function with its arguments.
    pub(crate) fn signature(&self) -> String {
        let names: Vec<_> = self.arguments.iter().map(|of| of.name).collect();
        format!("{}({})", self.name, names.join(", "))
    }
}

/// An error that names all fields without a value, if there are some.
pub(crate) fn require_values(names: &[String], values: &[f64]) -> PyResult<()> {
    let pairs = names.iter().zip(values);
    let missing = pairs.filter(|(_, value)| value.is_nan());
    let missing: Vec<_> = missing.map(|(name, _)| plain(name)).collect();
    let given = missing.iter().map(|name| format!("{name}=.."));
    let given = given.collect::<Vec<_>>().join(", ");
    let message = match &missing[..] {
        [] => return Ok(()),
        [name] => format!("field `{name}` has no value: `with_fields({given})` gives it one"),
        _ => {
            let names = missing.join("`, `");
            format!("fields `{names}` have no values: `with_fields({given})` gives them some")
        }
    };
    Err(PyValueError::new_err(message))
}

#[pymethods]
impl Function {
    #[pyo3(signature = (*arguments, **keywords))]
    fn __call__<'py>(
        &self,
        py: Python<'py>,
        arguments: &Bound<'py, PyTuple>,
        keywords: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let ready = self.ready(py)?;
        if keywords.is_none()
            && let Some(value) = call::of_one_state(py, ready, arguments)?
        {
            return Ok(value);
        }
        call::of_many(py, ready, arguments, keywords, call::evaluate)
    }

    /// The proven bounds of the rounding of the values: arrays as those of a call. Arguments and fields are exactly the
    /// doubles that they are. A bound is infinite where nothing is proven.
    #[pyo3(signature = (*arguments, **keywords))]
    fn bound<'py>(
        &self,
        py: Python<'py>,
        arguments: &Bound<'py, PyTuple>,
        keywords: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let ready = self.ready(py)?;
        call::of_many(py, ready, arguments, keywords, call::bounds)
    }

    /// The name.
    #[getter]
    fn __name__(&self) -> &str {
        self.description.request(self.place).name()
    }

    /// The function with its arguments, their shapes and units, and the settings of a call.
    #[getter]
    fn __doc__(&self) -> String {
        documentation::documentation(&self.description.robot, &self.request())
    }

    /// The signature that `inspect` and editors ask for.
    #[getter]
    fn __signature__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        documentation::signature(py, &self.description.robot, &self.request())
    }

    /// The names of the arguments.
    #[getter]
    fn arguments(&self) -> Vec<&'static str> {
        let arguments = documentation::arguments(&self.description.robot, &self.request());
        arguments.iter().map(|of| of.name).collect()
    }

    fn __repr__(&self) -> String {
        let (name, robot) = (self.__name__(), &self.description.robot.name);
        format!(
            "<function {name}({}) of {robot}>",
            self.arguments().join(", ")
        )
    }
}
