//! All that a call of a function needs to know.

use std::sync::Arc;

use dynamics_evaluation::{Arrangement, EvaluationError, RuntimeRobot};
use dynamics_symbolic::function::plain;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arguments::Argument;
use crate::description::Derived;

/// The most arguments of a call without detours.
pub(crate) const MOST_ARGUMENTS: usize = 5;

/// The most numbers of all its arguments and of its value for which it has room without asking for memory.
pub(crate) const SHORT: usize = 128;

/// A function that is ready to be called.
#[derive(Clone)]
pub(crate) struct Ready {
    pub(crate) arm: Arc<RuntimeRobot>,
    pub(crate) name: String,
    pub(crate) arguments: Vec<Argument>,
    pub(crate) arrangement: Arrangement,
    pub(crate) entries: usize,
    /// The fields, each as an argument that a call may have besides.
    pub(crate) fields: Vec<Argument>,
    /// Whether all of them have values.
    pub(crate) is_complete: bool,
    /// How many numbers all arguments of a state have.
    read: usize,
}

impl Ready {
    pub(crate) fn new(derived: &Derived, fields: &[f64]) -> PyResult<Self> {
        let error = |error: EvaluationError| PyValueError::new_err(error.to_string());
        let mut arm = Arc::clone(&derived.arm);
        if !fields.is_empty() {
            let mut with_fields = (*arm).clone();
            with_fields.set_fields(fields).map_err(error)?;
            arm = Arc::new(with_fields);
        }
        let name = derived.request.name();
        let moves = arm.robot().freedoms().has_base();
        let arguments = arm.arguments(name).map_err(error)?;
        let arguments = arguments.map(|(name, entries)| Argument::new(name, entries, moves));
        let arguments: Vec<_> = arguments.collect();
        Ok(Ready {
            fields: arm
                .field_names()
                .iter()
                .map(|name| Argument::field(plain(name)))
                .collect(),
            is_complete: !fields.iter().any(|x| x.is_nan()),
            read: arguments.iter().map(|of| of.entries).sum(),
            arguments,
            arrangement: arm.arrangement(name).map_err(error)?,
            entries: arm.entries(name).map_err(error)?,
            name: name.to_owned(),
            arm,
        })
    }

    /// Room for the arguments and for the value of one state.
    pub(crate) fn room<'a>(
        &self,
        few: &'a mut [f64; SHORT],
        many: &'a mut Vec<f64>,
    ) -> (&'a mut [f64], &'a mut [f64]) {
        let count = self.read + self.entries;
        let room = match few.get_mut(..count) {
            Some(room) => room,
            None => {
                many.resize(count, 0.0);
                many
            }
        };
        room.split_at_mut(self.read)
    }

    /// The function with its arguments.
    pub(crate) fn signature(&self) -> String {
        let names: Vec<_> = self.arguments.iter().map(|of| &*of.name).collect();
        format!("{}({})", self.name, names.join(", "))
    }
}

/// An error that names all fields without a value, if there are some.
pub(crate) fn require_values(names: &[String], values: &[f64]) -> PyResult<()> {
    let pairs = names.iter().zip(values);
    let missing = pairs.filter(|(_, value)| value.is_nan());
    let missing: Vec<_> = missing.map(|(name, _)| plain(name)).collect();
    let given = missing.iter().map(|name| format!("{name}=.."));
    let given = given.collect::<Vec<_>>().join(", ");
    let message = match &missing[..] {
        [] => return Ok(()),
        [name] => format!("field `{name}` has no value: `with_fields({given})` gives it one"),
        _ => {
            let names = missing.join("`, `");
            format!("fields `{names}` have no values: `with_fields({given})` gives them some")
        }
    };
    Err(PyValueError::new_err(message))
}
