//! Proven bounds of rounding.

use dynamics_runtime::Certified;

use crate::{EvaluationError, RuntimeRobot};

impl RuntimeRobot {
    /// The greatest distance of each entry of the value of a function from the exact one, in the order of
    /// [`evaluate_by_rows`](RuntimeRobot::evaluate_by_rows): those of [`Certified`] numbers, infinite where nothing is proven.
    /// Arguments and fields are exactly the doubles that they are.
    ///
    /// # Errors
    ///
    /// The errors of [`evaluate`](RuntimeRobot::evaluate).
    pub fn bounds_by_rows(
        &self,
        function: &str,
        arguments: &[&[f64]],
    ) -> Result<Vec<f64>, EvaluationError> {
        let exact = |entries: &&[f64]| entries.iter().map(|x| Certified::exact(*x)).collect();
        let exact: Vec<Vec<Certified>> = arguments.iter().map(exact).collect();
        let exact: Vec<&[Certified]> = exact.iter().map(Vec::as_slice).collect();
        let values = self.evaluate_in(function, &exact)?;
        let layout = &self.function(function)?.layout;
        let mut bounds = vec![0.0; values.len()];
        for ((_, row), (_, column)) in layout.by_rows.iter().zip(&layout.values) {
            bounds[*row] = values[*column].bound();
        }
        Ok(bounds)
    }
}

#[cfg(test)]
mod tests {
    use dynamics_symbolic::Function;

    use super::*;

    /// A zero is exact, a constant is wrong by half a unit in its last place, and a sum of products by a few roundings.
    #[test]
    fn bounds_are_those_of_rounding_by_rows() {
        let arm = RuntimeRobot::new(arms::robot("elbow_3r"), [Function::ForwardKinematics]);
        let arm = arm.unwrap();
        let q = [0.3, -1.1, 0.7];
        let bounds = arm.bounds_by_rows("forward_kinematics", &[&q]).unwrap();
        let mut pose = [0.0; 16];
        arm.evaluate_by_rows("forward_kinematics", &[&q], &mut pose)
            .unwrap();
        assert_eq!(bounds[12..], [0.0, 0.0, 0.0, f64::EPSILON / 2.0]);
        assert!(bounds[3] > 0.0 && bounds[3] < 1e-14, "{bounds:?}");
        assert_eq!(pose[12..], [0.0, 0.0, 0.0, 1.0]);
        assert!(arm.bounds_by_rows("jacobian", &[&q]).is_err());
    }
}
