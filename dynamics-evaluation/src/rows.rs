//! Values with matrices by rows, one state after the other, as arrays of numpy lie in memory.

use dynamics_symbolic::function::{Request, Shape, Size, Sizes};
use fearless_simd::Level;

use crate::compiled::check_length;
use crate::{EvaluationError, RuntimeRobot};

/// The arrangement of the value of a function at a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// An array of these sizes, the last of which varies fastest: none of a number, one of a vector, two of a matrix.
    Array(Vec<usize>),
    /// One after the other.
    Tuple(Vec<Arrangement>),
}

impl Arrangement {
    /// The arrangement of what is requested, of a robot of these sizes.
    #[doc(hidden)]
    pub fn of(request: &Request, sizes: Sizes) -> Self {
        let mut parts = request
            .functions()
            .map(|part| Arrangement::new(part.shape(), sizes));
        match parts.next() {
            Some(only) if !request.is_tuple() => only,
            first => Arrangement::Tuple(first.into_iter().chain(parts).collect()),
        }
    }

    fn new(shape: &Shape, sizes: Sizes) -> Self {
        match shape {
            Shape::Number => Arrangement::Array(Vec::new()),
            Shape::Matrix(rows, Size::One) => Arrangement::Array(vec![rows.of(sizes)]),
            Shape::Matrix(rows, columns) => {
                Arrangement::Array(vec![rows.of(sizes), columns.of(sizes)])
            }
            Shape::Each(count, one) => Arrangement::new(one, sizes).repeated(count.of(sizes)),
            Shape::Tuple(parts) => {
                let parts = parts.iter().map(|(_, part)| Arrangement::new(part, sizes));
                Arrangement::Tuple(parts.collect())
            }
            // Not evaluated here.
            Shape::Series => Arrangement::Tuple(Vec::new()),
        }
    }

    fn repeated(self, count: usize) -> Self {
        match self {
            Arrangement::Array(mut sizes) => {
                sizes.insert(0, count);
                Arrangement::Array(sizes)
            }
            tuple => Arrangement::Tuple(vec![tuple; count]),
        }
    }
}

impl RuntimeRobot {
    /// The arrangement of the value of a function.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotDerived`] where it was not requested.
    pub fn arrangement(&self, function: &str) -> Result<Arrangement, EvaluationError> {
        let function = self.function(function)?;
        Ok(Arrangement::of(&function.request, function.layout.sizes))
    }

    /// The entries of the value of a function at a state, in its [`arrangement`](RuntimeRobot::arrangement): the numbers of
    /// [`evaluate`](RuntimeRobot::evaluate), bit for bit.
    ///
    /// # Errors
    ///
    /// The errors of [`evaluate`](RuntimeRobot::evaluate), and [`EvaluationError::Length`] where the results are not as many
    /// as the function's [`entries`](RuntimeRobot::entries). The results are unspecified then.
    pub fn evaluate_by_rows(
        &self,
        function: &str,
        arguments: &[&[f64]],
        results: &mut [f64],
    ) -> Result<(), EvaluationError> {
        let function = self.function(function)?;
        check_length("results", results.len(), function.layout.entries())?;
        let Some((single, prepared)) = &function.single else {
            let by_columns = self.of_state(function, &function.shared, arguments, &|x| x)?;
            let places = function.layout.by_rows.iter().zip(&function.layout.values);
            for ((_, by_rows), (_, place)) in places {
                results[*by_rows] = by_columns[*place];
            }
            return Ok(());
        };
        function.check_lengths(arguments, 1)?;
        let written = single.values_by_rows(prepared, arguments, results);
        written.map_err(|error| self.singular(None, error))
    }

    /// The values of a function at many states, as [`batch`](RuntimeRobot::batch) has them, with matrices by rows.
    ///
    /// # Errors
    ///
    /// The errors of [`batch`](RuntimeRobot::batch).
    pub fn batch_by_rows(
        &self,
        function: &str,
        arguments: &[&[f64]],
        results: &mut [f64],
    ) -> Result<(), EvaluationError> {
        let function = self.function(function)?;
        self.batch_of(
            Level::new(),
            function,
            &function.layout.by_rows,
            arguments,
            results,
        )
    }
}

#[cfg(test)]
mod tests {
    use dynamics_symbolic::{Function, Request};

    use super::*;
    use crate::Value;

    /// The entries of a value, matrices by rows.
    fn by_rows(value: &Value) -> Vec<f64> {
        match value {
            Value::Number(x) => vec![*x],
            Value::Matrix(matrix) => matrix.transpose().as_slice().to_vec(),
            Value::Each(values) | Value::Tuple(values) => values.iter().flat_map(by_rows).collect(),
        }
    }

    fn arm() -> RuntimeRobot {
        let together = [Function::Jacobian, Function::KineticEnergy];
        let requests = [
            Request::from(Function::Jacobian),
            Request::from(Function::InverseDynamicsDerivatives),
            Request::from(Function::LinkJacobians),
            Request::fused("together", together),
        ];
        RuntimeRobot::new(arms::robot("elbow_3r"), requests).unwrap()
    }

    #[test]
    fn rows_hold_the_numbers_of_one_state_and_of_many() {
        let arm = arm();
        let (q, qd, qdd) = ([0.3, -1.1, 0.7], [0.2, 0.5, -0.9], [1.0, -2.0, 0.4]);
        for name in arm.function_names() {
            let given = [("q", &q), ("qd", &qd), ("qdd", &qdd)];
            let arguments = arm.arguments(name).unwrap();
            let arguments = arguments.filter_map(|(name, _)| {
                let found = given.iter().find(|(known, _)| *known == name);
                found.map(|(_, values)| values.as_slice())
            });
            let arguments: Vec<&[f64]> = arguments.collect();
            let value = arm.evaluate(name, &arguments).unwrap();
            let mut rows = vec![0.0; arm.entries(name).unwrap()];
            arm.evaluate_by_rows(name, &arguments, &mut rows).unwrap();
            assert_eq!(rows, by_rows(&value), "{name}");
            arm.batch_by_rows(name, &arguments, &mut rows).unwrap();
            for (row, exact) in rows.iter().zip(by_rows(&value)) {
                assert!((row - exact).abs() < 1e-13, "{name}: {row}, {exact}");
            }
        }
    }

    #[test]
    fn results_must_be_as_many_as_entries() {
        let refused = arm().evaluate_by_rows("jacobian", &[&[0.0; 3]], &mut [0.0; 17]);
        let expected = EvaluationError::Length {
            argument: "results",
            found: 17,
            expected: 18,
        };
        assert_eq!(refused, Err(expected));
    }

    #[test]
    fn arrangements_are_those_of_the_values() {
        let array = |sizes: &[usize]| Arrangement::Array(sizes.to_vec());
        let arm = arm();
        assert_eq!(arm.arrangement("jacobian"), Ok(array(&[6, 3])));
        assert_eq!(arm.arrangement("link_jacobians"), Ok(array(&[3, 6, 3])));
        let pair = |a, b| Arrangement::Tuple(vec![a, b]);
        let together = pair(array(&[6, 3]), array(&[]));
        assert_eq!(arm.arrangement("together"), Ok(together));
        let derivatives = pair(array(&[3, 3]), array(&[3, 3]));
        let found = arm.arrangement("inverse_dynamics_derivatives");
        assert_eq!(found, Ok(derivatives));
        assert!(arm.arrangement("mass_matrix").is_err());
    }
}
