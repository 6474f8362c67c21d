//! Inverse kinematics in closed form.

use dynamics_evaluation::dynamics_runtime::closed_form::NoSolution;
use dynamics_evaluation::dynamics_runtime::internal;
use dynamics_evaluation::dynamics_runtime::nalgebra::Matrix4;
use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::ready::require_values;
use crate::robot::Arm;

/// The closed form of a robot, for its tip or a frame.
#[pyclass(frozen, module = "robot_dynamics._native")]
pub(crate) struct ClosedForm(dynamics_evaluation::ClosedForm);

/// The solutions of a pose: positions, whether each is singular, the names of the branches, and why there are none.
type Solved<'py> = (
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray1<bool>>,
    Vec<String>,
    Option<&'static str>,
);

#[pymethods]
impl ClosedForm {
    /// Whether solutions are those of an angle of the elbow.
    #[getter]
    fn has_elbow(&self) -> bool {
        self.0.has_elbow()
    }

    /// For each joint whether it turns.
    #[getter]
    fn turns(&self) -> Vec<bool> {
        self.0.turns().to_vec()
    }

    /// The solutions of poses, rows of sixteen numbers, each at an angle of the elbow.
    fn solutions<'py>(
        &self,
        py: Python<'py>,
        poses: PyReadonlyArray2<'py, f64>,
        elbows: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Vec<Solved<'py>>> {
        let (poses, elbows) = (poses.as_slice()?, elbows.as_slice()?);
        let (form, joints) = (&self.0, self.0.joints());
        let solve = |(pose, elbow): (&[f64], &f64)| {
            form.solutions(&Matrix4::from_row_slice(pose), Some(*elbow))
        };
        let all: Vec<_> = py.detach(|| poses.chunks_exact(16).zip(elbows).map(solve).collect());
        let solved = all.into_iter().map(|found| {
            let (found, reason) = match found {
                Ok(found) => (found, None),
                Err(NoSolution::OutOfReach) => (Vec::new(), Some("out of reach")),
                Err(NoSolution::NotAPose) => (Vec::new(), Some("not a pose")),
            };
            let q: Vec<Vec<f64>> = found.iter().map(|one| one.q.clone()).collect();
            let q = match q[..] {
                [] => PyArray2::zeros(py, [0, joints], false),
                _ => PyArray2::from_vec2(py, &q)
                    .map_err(|error| PyValueError::new_err(error.to_string()))?,
            };
            let is_singular = found.iter().map(|one| one.is_singular);
            let is_singular = PyArray1::from_iter(py, is_singular);
            let branches = found.into_iter().map(|one| one.branch).collect();
            Ok((q, is_singular, branches, reason))
        });
        solved.collect()
    }

    /// The angle of seven joints' elbow by which these positions are found.
    fn elbow_angle(&self, q: Vec<f64>) -> PyResult<Option<f64>> {
        let angle = self.0.elbow_angle(&q);
        angle.map_err(|error| PyValueError::new_err(error.to_string()))
    }
}

#[pymethods]
impl Arm {
    /// The closed form for the tip, or for a frame.
    #[pyo3(signature = (frame=None))]
    fn closed_form(&self, py: Python<'_>, frame: Option<&str>) -> PyResult<ClosedForm> {
        let robot = self.with_functions(py, Vec::new())?;
        require_values(robot.field_names(), robot.fields())?;
        let form = py.detach(|| robot.closed_form(frame));
        form.map(ClosedForm)
            .map_err(|error| PyValueError::new_err(error.to_string()))
    }
}

/// The position that is whole turns away from q and nearest to another one, in a range if one of them is.
#[pyfunction]
#[pyo3(signature = (q, near, range=None))]
pub(crate) fn nearest_turn(q: f64, near: f64, range: Option<[f64; 2]>) -> f64 {
    internal::nearest_turn(q, near, range)
}
