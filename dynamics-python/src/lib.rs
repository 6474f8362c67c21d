//! The native part of the Python package `robot_dynamics`: robots at run time, and their functions over arrays.
//!
//! Physics is that of `dynamics-evaluation`. This layer reads arguments, hands out arrays and raises errors.
#![forbid(unsafe_code)]

mod arguments;
mod call;
mod closed_form;
mod description;
mod documentation;
mod errors;
mod force;
mod function;
mod mask;
mod motion;
mod pose;
mod questions;
mod reach;
mod ready;
mod results;
mod robot;
mod source;

use pyo3::prelude::*;

/// The native module that the Python modules of the package build on.
#[pymodule(gil_used = false)]
mod _native {
    /// The version of the package.
    #[allow(non_upper_case_globals)] // It is the name that Python's packages have for it.
    #[pymodule_export]
    const __version__: &str = env!("CARGO_PKG_VERSION");

    #[pymodule_export]
    use super::closed_form::{ClosedForm, nearest_turn};
    #[pymodule_export]
    use super::function::Function;
    #[pymodule_export]
    use super::mask::require_unmasked;
    #[pymodule_export]
    use super::robot::{Arm, text_of};
}
