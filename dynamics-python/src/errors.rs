//! Errors of Rust as exceptions of the package.

use std::ffi::CString;

use dynamics_codegen::positions_in_degrees;
use dynamics_evaluation::FileError;
use dynamics_symbolic::robot::Robot;
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyUserWarning};
use pyo3::prelude::*;

/// The module that has the exceptions.
const MODULE: &str = "robot_dynamics._errors";

/// An exception of the package, made of arguments.
fn raised<'py>(py: Python<'py>, name: &str, arguments: impl pyo3::call::PyCallArgs<'py>) -> PyErr {
    let made = || py.import(MODULE)?.getattr(name)?.call1(arguments);
    match made() {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}

/// `TableError`, with all mistakes; `FileNotFoundError` or another `OSError` of a file that cannot be read.
pub(crate) fn of_file(py: Python<'_>, error: &FileError) -> PyErr {
    match error {
        // Python takes the class that the number says: the first one, or of Windows the last one.
        FileError::Unreadable(file, reason, Some(number)) => {
            let reason = reason.split(" (os error").next().map(str::to_owned);
            PyOSError::new_err((*number, reason, file.display().to_string(), *number))
        }
        FileError::Unreadable(..) => PyOSError::new_err(error.to_string()),
        FileError::Mistakes(mistakes) => {
            let mistakes = mistakes.iter().map(|mistake| {
                let file = mistake.file.as_ref().map(|file| file.display().to_string());
                (file, mistake.line, mistake.column, mistake.message.clone())
            });
            let mistakes: Vec<_> = mistakes.collect();
            raised(py, "table_error", (mistakes,))
        }
        FileError::UnknownFormat(file) | FileError::Build(file, _) => {
            let file = file.display().to_string();
            let text = error.to_string();
            let message = text.strip_prefix(&format!("{file}:1:1: ")).unwrap_or(&text);
            raised(py, "table_error", (vec![(Some(&file), 1, 1, message)],))
        }
        other => PyRuntimeError::new_err(other.to_string()),
    }
}

/// `SingularMassMatrix` at a state, by its index along each of the leading axes.
pub(crate) fn singular(py: Python<'_>, index: Vec<usize>, joint: &str, reason: &str) -> PyErr {
    let index = pyo3::types::PyTuple::new(py, index);
    match index {
        Ok(index) => raised(py, "SingularMassMatrix", (index, joint, reason)),
        Err(error) => error,
    }
}

/// A `UserWarning` at the caller, so many calls of Python outwards.
pub(crate) fn warn(py: Python<'_>, text: &str, calls: i32) -> PyResult<()> {
    let text = CString::new(text)?;
    PyErr::warn(py, &py.get_type::<PyUserWarning>(), &text, calls)
}

/// The same if positions of joints were perhaps meant in degrees.
pub(crate) fn warn_of_degrees(
    py: Python<'_>,
    robot: &Robot,
    positions: &[f64],
    calls: i32,
) -> PyResult<()> {
    match positions_in_degrees(robot, positions) {
        Some(remark) => warn(py, &remark, calls),
        None => Ok(()),
    }
}
