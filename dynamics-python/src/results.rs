//! Results: arrays that are made, or those of the caller.

use dynamics_evaluation::Arrangement;
use numpy::ndarray::{ArrayView, IxDyn};
use numpy::{
    Element, PyArray, PyArray1, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods, PyUntypedArray,
    PyUntypedArrayMethods, ToPyArray,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PySlice, PyTuple};

use crate::arguments::{Rows, tuple};
use crate::mask::require_unmasked;
use crate::ready::Ready;

/// Numbers as an array of these axes, or as a number of numpy where there are none.
pub(crate) fn array<'py, T: Element>(
    py: Python<'py>,
    axes: &[usize],
    numbers: &[T],
) -> PyResult<Bound<'py, PyAny>> {
    let wrong = |error: numpy::ndarray::ShapeError| PyValueError::new_err(error.to_string());
    let array = match *axes {
        // A call is a tenth shorter where arrays of the usual numbers of axes are made so.
        [_] => return Ok(PyArray1::from_slice(py, numbers).into_any()),
        [rows, columns] => {
            let view = ArrayView::from_shape((rows, columns), numbers).map_err(wrong)?;
            return Ok(view.to_pyarray(py).into_any());
        }
        _ => ArrayView::from_shape(IxDyn(axes), numbers).map_err(wrong)?,
    };
    plain(array.to_pyarray(py).into_any(), axes)
}

/// The value of a function at a state, from the first of some numbers, which leaves the others.
pub(crate) fn value<'py, T: Element>(
    py: Python<'py>,
    arrangement: &Arrangement,
    numbers: &mut &[T],
) -> PyResult<Bound<'py, PyAny>> {
    match arrangement {
        Arrangement::Array(axes) => {
            let (own, others) = numbers.split_at(axes.iter().product());
            *numbers = others;
            array(py, axes, own)
        }
        Arrangement::Tuple(all) => {
            let values = all.iter().map(|one| value(py, one, numbers));
            let values: Vec<_> = values.collect::<PyResult<_>>()?;
            Ok(PyTuple::new(py, values)?.into_any())
        }
    }
}

/// An array without axes as a number, which is what functions of numpy return.
fn plain<'py>(array: Bound<'py, PyAny>, axes: &[usize]) -> PyResult<Bound<'py, PyAny>> {
    if axes.is_empty() {
        return array.get_item(PyTuple::empty(array.py()));
    }
    Ok(array)
}

/// The array that the caller has for the results.
pub(crate) struct Out<'py>(Option<Bound<'py, PyUntypedArray>>);

impl<'py> Out<'py> {
    /// `TypeError` and `ValueError` where it cannot take the results.
    pub(crate) fn new(
        ready: &Ready,
        lead: &[usize],
        is_single: bool,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Self> {
        let Some(out) = out else {
            return Ok(Out(None));
        };
        let Arrangement::Array(axes) = &ready.arrangement else {
            let message = format!("`out`: {} returns a tuple of arrays", ready.name);
            return Err(PyTypeError::new_err(message));
        };
        let Ok(out) = out.cast_into::<PyUntypedArray>() else {
            return Err(PyTypeError::new_err("`out` is no array of numpy"));
        };
        require_unmasked("out", &out, 0)?;
        let kind = out.dtype();
        let bytes = if is_single { 4 } else { 8 };
        if kind.kind() != b'f' || kind.itemsize() != bytes {
            return Err(PyTypeError::new_err(format!(
                "`out` is an array of {kind}: expected float{}",
                8 * bytes
            )));
        }
        let shape = [lead, axes].concat();
        if out.shape() != shape {
            return Err(PyValueError::new_err(format!(
                "`out` has the shape {}: expected {}",
                tuple(out.shape()),
                tuple(&shape)
            )));
        }
        Ok(Out(Some(out)))
    }
}

/// Room for the results of a call.
pub(crate) struct Results<'py> {
    /// The doubles of all states, one state after the other.
    rows: Bound<'py, PyArrayDyn<f64>>,
    /// The array of the caller, if it is another one.
    out: Option<Bound<'py, PyUntypedArray>>,
}

impl<'py> Results<'py> {
    pub(crate) fn new(
        py: Python<'py>,
        ready: &Ready,
        lead: &[usize],
        Out(out): Out<'py>,
        arguments: &[Rows<'py>],
    ) -> PyResult<Self> {
        let axes = match &ready.arrangement {
            Arrangement::Array(axes) => [lead, axes].concat(),
            Arrangement::Tuple(_) => [lead, &[ready.entries]].concat(),
        };
        // Into the memory of an argument the results are copied when all are known.
        if let Some(array) = &out
            && let Ok(doubles) = array.cast::<PyArrayDyn<f64>>()
            && doubles.is_c_contiguous()
            && doubles.is_aligned()
            && !arguments.iter().any(|rows| rows.overlap(doubles))
            && doubles.try_readwrite().is_ok()
        {
            let rows = doubles.clone();
            return Ok(Results { rows, out: None });
        }
        Ok(Results {
            rows: PyArray::zeros(py, axes, false),
            out,
        })
    }

    /// Hands out the room.
    pub(crate) fn fill<R>(&mut self, fill: impl FnOnce(&mut [f64]) -> R) -> PyResult<R> {
        let mut lock = self.rows.try_readwrite()?;
        Ok(fill(lock.as_slice_mut()?))
    }

    /// The value of a function with these leading axes.
    pub(crate) fn finish(
        self,
        py: Python<'py>,
        ready: &Ready,
        lead: &[usize],
        is_single: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        if let Some(out) = self.out {
            py.import("numpy")?
                .call_method1("copyto", (&out, self.rows, "same_kind"))?;
            return Ok(out.into_any());
        }
        let rows = self.rows.into_any();
        let rows = match is_single {
            true => rows.call_method1("astype", ("float32",))?,
            false => rows,
        };
        match &ready.arrangement {
            Arrangement::Array(axes) => plain(rows, &[lead, axes].concat()),
            tuple => parts(py, tuple, lead, &rows, &mut 0),
        }
    }
}

/// The values of an arrangement: arrays are copied out of the rows of tuples.
fn parts<'py>(
    py: Python<'py>,
    arrangement: &Arrangement,
    lead: &[usize],
    rows: &Bound<'py, PyAny>,
    first: &mut usize,
) -> PyResult<Bound<'py, PyAny>> {
    match arrangement {
        Arrangement::Array(axes) => {
            let count = axes.iter().product::<usize>();
            let range = PySlice::new(py, *first as isize, (*first + count) as isize, 1);
            *first += count;
            let part = rows.get_item((py.Ellipsis(), range))?;
            let shape = [lead, axes].concat();
            let part = part.call_method1("reshape", (PyTuple::new(py, &shape)?,))?;
            plain(part.call_method0("copy")?, &shape)
        }
        Arrangement::Tuple(all) => {
            let values = all.iter().map(|one| parts(py, one, lead, rows, first));
            let values: Vec<_> = values.collect::<PyResult<_>>()?;
            Ok(PyTuple::new(py, values)?.into_any())
        }
    }
}
