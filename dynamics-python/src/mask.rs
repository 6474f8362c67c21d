//! Masks of arrays, which functions of robots do not know.

use numpy::PyUntypedArray;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

/// `TypeError` of an array with a mask that masks some of its numbers, and of lists with such arrays. The array that is made of
/// all has so many axes.
#[pyfunction]
pub(crate) fn require_unmasked(name: &str, given: &Bound<'_, PyAny>, axes: usize) -> PyResult<()> {
    if !is_masked(given, axes)? {
        return Ok(());
    }
    Err(PyTypeError::new_err(format!(
        "`{name}` has a mask, which would be lost: `{name}.filled(np.nan)` is an array with NaN in the places that are masked"
    )))
}

fn is_masked(given: &Bound<'_, PyAny>, axes: usize) -> PyResult<bool> {
    if given.is_exact_instance_of::<PyUntypedArray>() {
        return Ok(false);
    }
    if given.is_instance_of::<PyUntypedArray>() {
        let Some(mask) = given.getattr_opt("mask")? else {
            return Ok(false);
        };
        let numpy = given.py().import("numpy")?;
        return numpy.call_method1("any", (mask,))?.is_truthy();
    }
    // A masked number in a list becomes NaN by numpy, with a warning.
    let is_list = given.is_instance_of::<PyList>() || given.is_instance_of::<PyTuple>();
    if axes > 1 && is_list {
        for one in given.try_iter()? {
            if is_masked(&one?, axes - 1)? {
                return Ok(true);
            }
        }
    }
    Ok(false)
}
