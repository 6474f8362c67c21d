//! The functions by their names, as a generated struct has them.

use dynamics_runtime::nalgebra::{DMatrix, DVector};

use crate::value::FromValue;
use crate::{EvaluationError, RuntimeRobot};

dynamics_items::runtime_methods! {}

impl RuntimeRobot {
    fn of_kind<V: FromValue>(
        &self,
        function: &str,
        arguments: &[&[f64]],
    ) -> Result<V, EvaluationError> {
        let value = self.evaluate(function, arguments)?;
        // A method of several functions that was given the name of one has another value.
        V::from_value(value).ok_or_else(|| EvaluationError::NotDerived(function.to_owned()))
    }
}
