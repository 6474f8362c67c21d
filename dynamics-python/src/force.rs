//! The forces of the motors: constant, or a law of Python.

use std::cell::{Cell, RefCell};

use dynamics_runtime::Pose;
use dynamics_runtime::nalgebra::DVector;
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::motion::by_rows;
use crate::results::array;

/// After so many calls of a constant force signals such as Ctrl-C are looked for.
const BETWEEN_SIGNALS: u32 = 1024;

/// A law of the forces, and the exception that it raised.
pub(crate) struct Force {
    law: Option<Py<PyAny>>,
    constant: DVector<f64>,
    failure: RefCell<Option<PyErr>>,
    calls: Cell<u32>,
}

impl Force {
    pub(crate) fn new(law: Option<Py<PyAny>>, constant: Vec<f64>) -> Self {
        Force {
            law,
            constant: constant.into(),
            failure: RefCell::default(),
            calls: Cell::new(0),
        }
    }

    /// The exception by which the law, or Ctrl-C, ended the run.
    pub(crate) fn into_failure(self) -> Option<PyErr> {
        self.failure.into_inner()
    }

    /// The forces; NaN once the law has failed, which ends the run.
    pub(crate) fn at(
        &self,
        t: f64,
        base: Option<&Pose<f64>>,
        q: &DVector<f64>,
        v: &DVector<f64>,
    ) -> DVector<f64> {
        if self.failure.borrow().is_some() {
            return self.constant.map(|_| f64::NAN);
        }
        let calls = self.calls.get().wrapping_add(1);
        self.calls.set(calls);
        let forces = match &self.law {
            Some(law) => Python::attach(|py| self.of_law(py, law, t, base, q, v)),
            None if calls.is_multiple_of(BETWEEN_SIGNALS) => {
                let heard = Python::attach(|py| py.check_signals());
                heard.map(|()| self.constant.clone())
            }
            None => Ok(self.constant.clone()),
        };
        forces.unwrap_or_else(|failure| {
            self.failure.replace(Some(failure));
            self.constant.map(|_| f64::NAN)
        })
    }

    fn of_law(
        &self,
        py: Python<'_>,
        law: &Py<PyAny>,
        t: f64,
        base: Option<&Pose<f64>>,
        q: &DVector<f64>,
        v: &DVector<f64>,
    ) -> PyResult<DVector<f64>> {
        let [q, v] = [q, v].map(|x| PyArray1::from_slice(py, x.as_slice()));
        let forces = match base {
            None => law.call1(py, (t, q, v))?,
            Some(base) => {
                let pose = array(py, &[4, 4], &by_rows(base))?;
                law.call1(py, (t, pose, q, v))?
            }
        };
        let forces: Vec<f64> = forces.extract(py)?;
        if forces.len() != self.constant.len() {
            return Err(PyValueError::new_err(format!(
                "`torque` returned {} numbers: expected {}",
                forces.len(),
                self.constant.len()
            )));
        }
        Ok(forces.into())
    }
}
