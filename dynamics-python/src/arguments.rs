//! Arguments: arrays of any shape, strides and kind of numbers, read as rows of doubles.

use std::borrow::Cow;

use dynamics_simulation::simulation::InvalidSetting;
use numpy::{
    Element, PyArray1, PyArray2, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods,
    PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt, PyList};

use crate::mask::require_unmasked;
use crate::pose::pose_of;

/// An argument of a function, or a field that a call has a value of.
#[derive(Clone)]
pub(crate) struct Argument {
    pub(crate) name: Cow<'static, str>,
    /// How many numbers a state has.
    pub(crate) entries: usize,
    /// The axes of a state: one, or two of a pose.
    axes: Vec<usize>,
}

/// The numbers of an argument, as far as a call of one state has to know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Double,
    Single,
    /// Integers, and numbers in lists.
    Written,
}

/// A number of an array, which is read as a double.
trait Number: Element + Copy {
    fn double(self) -> f64;
}

macro_rules! numbers {
    ($($kind:ty)*) => {
        $(impl Number for $kind {
            #[inline(always)]
            fn double(self) -> f64 {
                self as f64
            }
        })*
    };
}
numbers!(f64 f32 i64 i32);

/// The name of the pose of a base that moves.
const BASE: &str = "base";

/// The name of an argument of a robot whose base moves or stands: the velocities of a base are no derivatives of
/// positions.
fn name_of(name: &'static str, moves: bool) -> &'static str {
    match name {
        "qd" if moves => "v",
        "qdd" if moves => "a",
        name => name,
    }
}

impl Argument {
    /// An argument of so many numbers, of a robot whose base moves or stands.
    pub(crate) fn new(name: &'static str, entries: usize, moves: bool) -> Self {
        let axes = match name {
            BASE => vec![4, 4],
            _ => vec![entries],
        };
        Argument {
            name: name_of(name, moves).into(),
            entries,
            axes,
        }
    }

    /// A field of that name.
    pub(crate) fn field(name: &str) -> Self {
        Argument {
            name: name.to_owned().into(),
            entries: 1,
            axes: Vec::new(),
        }
    }

    fn is_pose(&self) -> bool {
        self.name == BASE
    }

    /// Reads one state, of an array of numpy or a list of numbers; `None` of what numpy has to convert.
    #[inline]
    pub(crate) fn read(&self, given: &Bound<'_, PyAny>, to: &mut [f64]) -> PyResult<Option<Kind>> {
        if !self.is_pose() {
            return Ok(state(given, &self.axes, to));
        }
        let mut matrix = [0.0; 16];
        let kind = state(given, &self.axes, &mut matrix);
        if kind.is_some() {
            to.copy_from_slice(&entries_of_pose(&matrix)?);
        }
        Ok(kind)
    }

    pub(crate) fn shape(&self) -> String {
        shape(&self.axes)
    }
}

/// An argument of a call, with its leading axes.
pub(crate) struct Given<'a, 'py> {
    argument: &'a Argument,
    array: Bound<'py, PyUntypedArray>,
    /// The axes before those of a state.
    pub(crate) lead: Vec<usize>,
}

impl<'a, 'py> Given<'a, 'py> {
    /// The array of an argument: `TypeError` of other numbers than real ones and of masks, `ValueError` of a wrong shape.
    pub(crate) fn new(argument: &'a Argument, given: &Bound<'py, PyAny>) -> PyResult<Self> {
        let array = match given.cast::<PyUntypedArray>() {
            Ok(array) => array.clone(),
            Err(_) => as_array(argument, given)?,
        };
        require_unmasked(&argument.name, given, array.ndim())?;
        let kind = array.dtype();
        let is_real = match kind.kind() {
            b'i' | b'u' => true,
            b'f' => matches!(kind.itemsize(), 4 | 8),
            _ => false,
        };
        if !is_real {
            return Err(PyTypeError::new_err(format!(
                "`{}` is an array of {kind}: expected float64, float32 or integers",
                argument.name
            )));
        }
        let shape = array.shape();
        let Some(lead) = shape.strip_suffix(&argument.axes[..]) else {
            return Err(PyValueError::new_err(format!(
                "`{}` has the shape {}: expected {}",
                argument.name,
                tuple(shape),
                argument.shape()
            )));
        };
        Ok(Given {
            argument,
            lead: lead.to_vec(),
            array,
        })
    }

    pub(crate) fn name(&self) -> &'a str {
        &self.argument.name
    }

    /// Whether the numbers are floating-point ones of so many bytes.
    pub(crate) fn is_float(&self, bytes: usize) -> bool {
        let kind = self.array.dtype();
        kind.kind() == b'f' && kind.itemsize() == bytes
    }

    pub(crate) fn array(&self) -> &Bound<'py, PyUntypedArray> {
        &self.array
    }

    /// The numbers of all states, one state after the other in memory.
    pub(crate) fn rows(&self, lead: &[usize]) -> PyResult<Rows<'py>> {
        let own = self.numbers()?;
        let own = match self.argument.is_pose() {
            true => {
                let (poses, _) = own.as_slice()?.as_chunks();
                let entries = poses.iter().map(entries_of_pose);
                Rows::Own(entries.collect::<PyResult<Vec<_>>>()?.concat())
            }
            false => own,
        };
        if self.lead == lead {
            return Ok(own);
        }
        let states: usize = lead.iter().product();
        let mut all = Vec::with_capacity(states * self.argument.entries);
        let axes = [&vec![1; lead.len() - self.lead.len()], &self.lead[..]].concat();
        repeat(own.as_slice()?, &axes, lead, &mut all);
        Ok(Rows::Own(all))
    }

    /// The numbers of the argument's own states.
    fn numbers(&self) -> PyResult<Rows<'py>> {
        if let Some(rows) = in_order(&self.array)? {
            return Ok(rows);
        }
        let numpy = self.array.py().import("numpy")?;
        let array = numpy.call_method1("ascontiguousarray", (&self.array, "float64"))?;
        // Doubles that are not aligned are those that were given. A copy is aligned.
        let array = numpy.call_method1("array", (array,))?.cast_into()?;
        in_order(&array)?.ok_or_else(|| PyTypeError::new_err("numpy made no array of float64"))
    }
}

/// The numbers of an argument, one state after the other in memory.
pub(crate) enum Rows<'py> {
    /// The caller's array.
    Given(PyReadonlyArrayDyn<'py, f64>),
    Own(Vec<f64>),
}

impl Rows<'_> {
    pub(crate) fn as_slice(&self) -> PyResult<&[f64]> {
        match self {
            Rows::Given(array) => Ok(array.as_slice()?),
            Rows::Own(numbers) => Ok(numbers),
        }
    }

    /// Whether they share memory with an array of numbers one after the other, whatever objects own it: addresses decide.
    pub(crate) fn overlap(&self, other: &Bound<'_, PyArrayDyn<f64>>) -> bool {
        let Rows::Given(array) = self else {
            return false;
        };
        let [(a, a_end), (b, b_end)] = [array, other].map(|array| {
            let first = array.data().addr();
            (first, first + size_of::<f64>() * array.len())
        });
        a < b_end && b < a_end
    }
}

/// The numbers of an array that lie one after the other; `None` of another array, or of other numbers than are read here.
fn in_order<'py>(array: &Bound<'py, PyUntypedArray>) -> PyResult<Option<Rows<'py>>> {
    if !(array.is_c_contiguous() && array.is_aligned()) {
        return Ok(None);
    }
    if let Ok(doubles) = array.cast::<PyArrayDyn<f64>>() {
        return Ok(Some(Rows::Given(doubles.try_readonly()?)));
    }
    fn converted<T: Number>(array: &Bound<'_, PyUntypedArray>) -> PyResult<Option<Vec<f64>>> {
        let Ok(array) = array.cast::<PyArrayDyn<T>>() else {
            return Ok(None);
        };
        let numbers = array.try_readonly()?;
        let numbers = numbers.as_slice()?.iter();
        Ok(Some(numbers.map(|x| x.double()).collect()))
    }
    let mut found = converted::<f32>(array)?;
    for convert in [converted::<i64>, converted::<i32>] {
        if found.is_none() {
            found = convert(array)?;
        }
    }
    Ok(found.map(Rows::Own))
}

/// Writes the rows of states, whose leading axes are as many as all have, once for each of all.
fn repeat(rows: &[f64], own: &[usize], lead: &[usize], to: &mut Vec<f64>) {
    match (own, lead) {
        ([axis, own @ ..], [count, lead @ ..]) if !rows.is_empty() => {
            let part = rows.len() / axis;
            for k in 0..*count {
                let first = if *axis == 1 { 0 } else { k * part };
                repeat(&rows[first..first + part], own, lead, to);
            }
        }
        _ => to.extend_from_slice(rows),
    }
}

/// Reads an array of these axes or a list, of which numpy need not be asked.
#[inline]
fn state(given: &Bound<'_, PyAny>, axes: &[usize], to: &mut [f64]) -> Option<Kind> {
    let Ok(array) = given.cast_exact::<PyUntypedArray>() else {
        let is_vector = axes.len() == 1;
        return is_vector
            .then(|| listed(given, to))?
            .map(|()| Kind::Written);
    };
    if array.shape() != axes || !array.is_aligned() {
        return None;
    }
    let kind = array.dtype();
    match (kind.kind(), kind.itemsize()) {
        (b'f', 8) => entries::<f64>(array, to).map(|()| Kind::Double),
        (b'f', 4) => entries::<f32>(array, to).map(|()| Kind::Single),
        (b'i', 8) => entries::<i64>(array, to).map(|()| Kind::Written),
        (b'i', 4) => entries::<i32>(array, to).map(|()| Kind::Written),
        _ => None,
    }
}

/// Reads the entries of a vector, or of a matrix by rows.
#[inline]
fn entries<T: Number>(array: &Bound<'_, PyUntypedArray>, to: &mut [f64]) -> Option<()> {
    if let Ok(vector) = array.cast::<PyArray1<T>>() {
        for (k, x) in to.iter_mut().enumerate() {
            *x = vector.get_owned([k])?.double();
        }
        return Some(());
    }
    let matrix = array.cast::<PyArray2<T>>().ok()?;
    let columns = matrix.shape()[1];
    for (k, x) in to.iter_mut().enumerate() {
        *x = matrix.get_owned([k / columns, k % columns])?.double();
    }
    Some(())
}

/// Reads a list of numbers of Python.
fn listed(given: &Bound<'_, PyAny>, to: &mut [f64]) -> Option<()> {
    let list = given.cast_exact::<PyList>().ok()?;
    if list.len() != to.len() {
        return None;
    }
    for (x, one) in to.iter_mut().zip(list) {
        *x = match one.cast::<PyFloat>() {
            Ok(number) => number.value(),
            Err(_) => one
                .cast_exact::<PyInt>()
                .ok()?
                .extract::<i64>()
                .ok()?
                .double(),
        };
    }
    Some(())
}

/// Lists of numbers, and whatever numpy takes for an array.
fn as_array<'py>(
    argument: &Argument,
    given: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyUntypedArray>> {
    let py = given.py();
    let array = py.import("numpy")?.call_method1("asarray", (given,));
    let array = array.map_err(|error| {
        let message = format!("`{}` is no array: {}", argument.name, error.value(py));
        PyValueError::new_err(message)
    })?;
    Ok(array.cast_into::<PyUntypedArray>()?)
}

/// Refuses a matrix by rows that is no homogeneous transform, such as a transposed one. NaN may stand for a pose that is unknown.
pub(crate) fn require_transform(name: &str, matrix: &[f64]) -> PyResult<()> {
    let last = &matrix[12..16];
    let misses = |(x, expected): (&f64, f64)| (x - expected).abs() > 1e-6;
    if !last.iter().zip([0.0, 0.0, 0.0, 1.0]).any(misses) {
        return Ok(());
    }
    let is_transposed = last[3] == 1.0 && [3, 7, 11].iter().all(|k| matrix[*k] == 0.0);
    let way_out = if is_transposed {
        ", so it is transposed: rows and columns change places"
    } else {
        ""
    };
    Err(PyValueError::new_err(format!(
        "`{name}` is no homogeneous transform, whose last row is [0, 0, 0, 1]: its last row is {last:?}{way_out}"
    )))
}

/// A homogeneous matrix as twelve numbers: the rotation by rows, then the position. Refuses a rotation that is none, as a
/// simulation does. NaN may stand for a pose that is unknown.
fn entries_of_pose(matrix: &[f64; 16]) -> PyResult<[f64; 12]> {
    require_transform(BASE, matrix)?;
    let pose = pose_of(matrix);
    if !pose.has_rotation() && !matrix.iter().any(|x| x.is_nan()) {
        let message = InvalidSetting::Rotation.to_string();
        return Err(PyValueError::new_err(message));
    }
    Ok(pose.entries().into())
}

/// The axes that all leading axes are broadcast to, as numpy does.
pub(crate) fn broadcast(given: &[Given<'_, '_>]) -> PyResult<Vec<usize>> {
    let mut all: Vec<usize> = Vec::new();
    for one in given {
        let longest = all.len().max(one.lead.len());
        let of = |lead: &[usize], k: usize| (k < lead.len()).then(|| lead[lead.len() - 1 - k]);
        let axis = |k: usize| match (of(&all, k).unwrap_or(1), of(&one.lead, k).unwrap_or(1)) {
            (a, b) if a == b => Some(a),
            (1, b) => Some(b),
            (a, 1) => Some(a),
            _ => None,
        };
        let axes: Option<Vec<usize>> = (0..longest).rev().map(axis).collect();
        all = axes.ok_or_else(|| {
            PyValueError::new_err(format!(
                "`{}` has the leading axes {}, the arguments before it {}: they cannot be broadcast together",
                one.name(),
                tuple(&one.lead),
                tuple(&all)
            ))
        })?;
    }
    Ok(all)
}

/// A shape as Python writes it.
pub(crate) fn tuple(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        _ => {
            let sizes: Vec<_> = shape.iter().map(usize::to_string).collect();
            format!("({})", sizes.join(", "))
        }
    }
}

/// A size that is not known: the number P of base parameters.
pub(crate) const UNKNOWN: usize = usize::MAX;

/// A shape of any leading axes.
pub(crate) fn shape(axes: &[usize]) -> String {
    let sizes = axes.iter().map(|size| match *size {
        UNKNOWN => ", P".to_owned(),
        size => format!(", {size}"),
    });
    format!("(...{})", sizes.collect::<String>())
}
