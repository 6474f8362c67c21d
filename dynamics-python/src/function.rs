//! A function of a robot, as Python calls it.

use std::sync::{Arc, OnceLock};

use dynamics_symbolic::Request;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::call;
use crate::description::Description;
use crate::documentation;
use crate::ready::Ready;

// A function of a robot. It is derived at its first call, and kept. A documentation of the class, which the stub has,
// would take the place of the functions' own.
#[pyclass(frozen, module = "robot_dynamics")]
pub(crate) struct Function {
    description: Arc<Description>,
    place: usize,
    fields: Arc<[f64]>,
    ready: OnceLock<Ready>,
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
    fn arguments(&self) -> Vec<String> {
        let arguments = documentation::arguments(&self.description.robot, &self.request());
        arguments.iter().map(|of| of.name.to_string()).collect()
    }

    fn __repr__(&self) -> String {
        let (name, robot) = (self.__name__(), &self.description.robot.name);
        format!(
            "<function {name}({}) of {robot}>",
            self.arguments().join(", ")
        )
    }
}
