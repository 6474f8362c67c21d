//! Arguments: arrays of any shape, strides and kind of numbers, read as rows of doubles.

use dynamics_simulation::simulation::InvalidSetting;
use numpy::{
    PyArrayDescrMethods, PyArrayDyn, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::mask::require_unmasked;
use crate::pose::pose_of;

/// An argument of a function.
pub(crate) struct Argument {
    pub(crate) name: &'static str,
    /// How many numbers a state has.
    pub(crate) entries: usize,
    /// The axes of a state: one, or two of a pose.
    axes: Vec<usize>,
}

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
            name: name_of(name, moves),
            entries,
            axes,
        }
    }

    pub(crate) fn is_pose(&self) -> bool {
        self.name == BASE
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
        require_unmasked(argument.name, given, array.ndim())?;
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

    pub(crate) fn name(&self) -> &'static str {
        self.argument.name
    }

    /// Whether the numbers are doubles.
    pub(crate) fn is_double(&self) -> bool {
        let kind = self.array.dtype();
        kind.kind() == b'f' && kind.itemsize() == 8
    }

    pub(crate) fn array(&self) -> &Bound<'py, PyUntypedArray> {
        &self.array
    }

    /// The numbers of all states, one state after the other in memory.
    pub(crate) fn rows(&self, lead: &[usize]) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        if !self.argument.is_pose()
            && self.lead == lead
            && let Ok(array) = self.array.cast::<PyArrayDyn<f64>>()
            && array.is_c_contiguous()
            && array.is_aligned()
        {
            return Ok(array.clone());
        }
        let py = self.array.py();
        let numpy = py.import("numpy")?;
        let numbers = numpy.call_method1("asarray", (&self.array, "float64"))?;
        let numbers = match self.argument.is_pose() {
            true => entries_of_poses(&numpy, &numbers, &self.lead)?,
            false => numbers,
        };
        let mut shape = lead.to_vec();
        shape.push(self.argument.entries);
        let shape = PyTuple::new(py, shape)?;
        let all = numpy.call_method1("broadcast_to", (numbers, shape))?;
        slice_of(&numpy, &all)
    }
}

/// The doubles of an array as a slice of Rust has them: one after the other, and aligned.
fn slice_of<'py>(
    numpy: &Bound<'py, PyModule>,
    array: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    // An array of no axes but one stays one: `ascontiguousarray` is of one axis at least.
    let array = numpy.call_method1("ascontiguousarray", (array,))?;
    let array: Bound<'py, PyArrayDyn<f64>> = array.cast_into()?;
    match array.is_aligned() {
        true => Ok(array),
        // A copy is.
        false => Ok(array.call_method0("copy")?.cast_into()?),
    }
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

/// Refuses a pose whose rotation is none, as a simulation does. NaN may stand for a pose that is unknown.
fn require_rotation(matrix: &[f64]) -> PyResult<()> {
    let is_unknown = matrix.iter().any(|x| x.is_nan());
    if is_unknown || pose_of(matrix).has_rotation() {
        return Ok(());
    }
    let message = InvalidSetting::Rotation.to_string();
    Err(PyValueError::new_err(message))
}

/// Homogeneous matrices as twelve numbers each: the rotation by rows, then the position.
fn entries_of_poses<'py>(
    numpy: &Bound<'py, PyModule>,
    poses: &Bound<'py, PyAny>,
    lead: &[usize],
) -> PyResult<Bound<'py, PyAny>> {
    let py = poses.py();
    let shape = |entries: usize| {
        let mut shape = lead.to_vec();
        shape.push(entries);
        PyTuple::new(py, shape)
    };
    let flat = poses.call_method1("reshape", (shape(16)?,))?;
    let numbers = slice_of(numpy, &flat)?;
    for pose in numbers.try_readonly()?.as_slice()?.chunks_exact(16) {
        require_transform(BASE, pose)?;
        require_rotation(pose)?;
    }
    let places = [0, 1, 2, 4, 5, 6, 8, 9, 10, 3, 7, 11];
    numpy.call_method1("take", (flat, places.to_vec(), -1))
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
