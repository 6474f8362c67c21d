//! Masks of arrays, which functions of robots do not know.

use numpy::{PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyList, PyTuple};

/// `TypeError` of an array with a mask that masks some of its numbers, and of lists with such arrays.
#[pyfunction]
pub(crate) fn require_unmasked(name: &str, given: &Bound<'_, PyAny>) -> PyResult<()> {
    if !is_masked(given)? {
        return Ok(());
    }
    Err(PyTypeError::new_err(format!(
        "`{name}` has a mask, which would be lost: `{name}.filled(np.nan)` is an array with NaN in the places that are masked"
    )))
}

fn is_masked(given: &Bound<'_, PyAny>) -> PyResult<bool> {
    if given.is_exact_instance_of::<PyFloat>() || given.is_exact_instance_of::<PyUntypedArray>() {
        return Ok(false);
    }
    if given.is_instance_of::<PyUntypedArray>() {
        let mask = given.getattr_opt("mask")?;
        let numpy = given.py().import("numpy")?;
        return mask.map_or(Ok(false), |mask| {
            numpy.call_method1("any", (mask,))?.is_truthy()
        });
    }
    if given.is_instance_of::<PyList>() || given.is_instance_of::<PyTuple>() {
        for one in given.try_iter()? {
            if is_masked(&one?)? {
                return Ok(true);
            }
        }
    }
    Ok(false)
}
