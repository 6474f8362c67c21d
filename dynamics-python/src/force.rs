//! The forces of the motors, constant or a law of Python, and those of the surroundings.

use std::cell::{Cell, RefCell};

use dynamics_runtime::nalgebra::{DVector, Dyn, Matrix4, Vector6};
use dynamics_simulation::simulation::Place;
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::mask::require_unmasked;
use crate::pose::{by_rows, rows_of};
use crate::results::array;

/// After so many calls of a constant force signals such as Ctrl-C are looked for.
const BETWEEN_SIGNALS: u32 = 1024;

/// A law of the forces, and the exception that it, or a law of the surroundings, raised.
pub(crate) struct Force {
    law: Option<Py<PyAny>>,
    constant: DVector<f64>,
    failure: RefCell<Option<PyErr>>,
    calls: Cell<u32>,
}

/// A law of the surroundings at a frame, or at the tip.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Wrench {
    pub(crate) frame: Option<String>,
    law: Py<PyAny>,
    /// The name of the law in messages.
    name: String,
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
    pub(crate) fn at(&self, t: f64, place: &Place<Dyn>, v: &DVector<f64>) -> DVector<f64> {
        if self.failure.borrow().is_some() {
            return self.constant.map(|_| f64::NAN);
        }
        let calls = self.calls.get().wrapping_add(1);
        self.calls.set(calls);
        let forces = match &self.law {
            Some(law) => Python::attach(|py| self.of_law(py, law, t, place, v)),
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
        place: &Place<Dyn>,
        v: &DVector<f64>,
    ) -> PyResult<DVector<f64>> {
        let [q, v] = [&place.q, v].map(|x| PyArray1::from_slice(py, x.as_slice()));
        let forces = match &place.base {
            None => law.call1(py, (t, q, v))?,
            Some(base) => {
                let pose = array(py, &[4, 4], &by_rows(base))?;
                law.call1(py, (t, pose, q, v))?
            }
        };
        Ok(numbers("torque", forces.bind(py), self.constant.len())?.into())
    }

    /// The force and the moment of the surroundings at a place; NaN once a law has failed.
    pub(crate) fn wrench(
        &self,
        of: &Wrench,
        t: f64,
        pose: &Matrix4<f64>,
        twist: &Vector6<f64>,
    ) -> Vector6<f64> {
        if self.failure.borrow().is_some() {
            return Vector6::repeat(f64::NAN);
        }
        let wrench = Python::attach(|py| {
            let pose = array(py, &[4, 4], &rows_of(pose))?;
            let twist = PyArray1::from_slice(py, twist.as_slice());
            let wrench = of.law.call1(py, (t, pose, twist))?;
            numbers(&of.name, wrench.bind(py), 6)
        });
        match wrench {
            Ok(wrench) => Vector6::from_column_slice(&wrench),
            Err(failure) => {
                self.failure.replace(Some(failure));
                Vector6::repeat(f64::NAN)
            }
        }
    }
}

/// The numbers that a law returned.
fn numbers(law: &str, returned: &Bound<'_, PyAny>, expected: usize) -> PyResult<Vec<f64>> {
    require_unmasked(law, returned, 1)?;
    let message = match returned.extract::<Vec<f64>>() {
        Ok(numbers) if numbers.len() == expected => return Ok(numbers),
        Ok(numbers) => format!("{} numbers: expected {expected}", numbers.len()),
        Err(_) => match returned.getattr("shape") {
            Ok(shape) => format!("an array of the shape {shape}: expected ({expected},)"),
            Err(_) => format!("{}: expected {expected} numbers", returned.repr()?),
        },
    };
    Err(PyValueError::new_err(format!("`{law}` returned {message}")))
}
