//! Numeric inverse kinematics.

use dynamics_numeric::InverseKinematics;
use dynamics_numeric::inverse_kinematics::{NotReached, Places, Reached, Target};
use dynamics_runtime::SizedKinematics as _;
use dynamics_runtime::nalgebra::{DVector, Dyn, Matrix3, Vector3};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arguments::require_transform;
use crate::errors::warn_of_degrees;
use crate::motion::CALLS_TO_MOVE;
use crate::robot::Arm;

/// A frame by its name, none for the tip, with the numbers of its target, a position besides, and weights.
type OfFrame = (Option<String>, Vec<f64>, Option<[f64; 3]>, [f64; 2]);

/// The request of a search.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Asked {
    targets: Vec<OfFrame>,
    start: Vec<f64>,
    posture: Option<Vec<f64>>,
    tolerance: [f64; 2],
    attempts: usize,
    seed: u64,
    /// The most solutions.
    most: usize,
    joint_names: Vec<String>,
}

/// Joint positions, and what is missing there, m and rad.
type Found = (Vec<f64>, f64, f64);

/// Why there are none, and whether something else was requested than targets can be.
type Failed = (String, bool);

/// The target that so many numbers say: a position, an axis and its direction, a rotation or a pose, by rows; with a
/// position besides, and with weights.
fn target(
    numbers: &[f64],
    position: Option<[f64; 3]>,
    [of_position, of_rotation]: [f64; 2],
) -> PyResult<Target> {
    let vector = |first: usize| Vector3::from_column_slice(&numbers[first..first + 3]);
    let rotation = |width: usize| Matrix3::from_fn(|i, j| numbers[width * i + j]);
    let target = match numbers.len() {
        3 => Target::position(vector(0)),
        6 => Target::pointing(vector(0), vector(3)),
        9 => Target::rotation(rotation(3)),
        16 => {
            require_transform("target", numbers)?;
            let origin = Vector3::new(numbers[3], numbers[7], numbers[11]);
            Target::rotation(rotation(4)).at(origin)
        }
        _ => return Err(PyValueError::new_err("a target of other numbers")),
    };
    let target = match position {
        Some(position) => target.at(position.into()),
        None => target,
    };
    Ok(target.weights(of_position, of_rotation))
}

/// The joint positions that are found, or those that came nearest with the reason.
fn search<P: Places<Dyn>>(
    solver: InverseKinematics<Dyn, P>,
    targets: &[Target],
    asked: &Asked,
) -> (Vec<Found>, Option<Failed>) {
    let [position, rotation] = asked.tolerance;
    let solver = solver
        .tolerance(position, rotation)
        .attempts(asked.attempts)
        .seed(asked.seed);
    let solver = match &asked.posture {
        Some(posture) => solver.posture(DVector::from_column_slice(posture)),
        None => solver,
    };
    let start = DVector::from_column_slice(&asked.start);
    let found = match asked.most {
        1 => solver
            .solve_all(targets, &start)
            .map(|reached| vec![reached]),
        most => solver.solutions(targets, &start, most),
    };
    let entries = |q: &DVector<f64>| q.as_slice().to_vec();
    match found {
        Ok(found) => {
            let found = found.iter().map(|Reached::<Dyn> { q, residual, .. }| {
                (entries(q), residual.position, residual.rotation)
            });
            (found.collect(), None)
        }
        Err(error) => {
            let error = error.naming(&asked.joint_names);
            let NotReached::<Dyn> {
                q,
                residual,
                attempts,
                ..
            } = &error;
            let failed = (error.to_string(), *attempts == 0);
            (
                vec![(entries(q), residual.position, residual.rotation)],
                Some(failed),
            )
        }
    }
}

#[pymethods]
impl Arm {
    /// Joint positions at which frames reach their targets; or those that came nearest, and why.
    fn reach(&self, py: Python<'_>, asked: Asked) -> PyResult<(Vec<Found>, Option<Failed>)> {
        if self.description.robot.freedoms().has_base() {
            let message = "`reach` is of a robot whose base stands: this one moves";
            return Err(PyValueError::new_err(message));
        }
        warn_of_degrees(py, &self.description.robot, &asked.start, CALLS_TO_MOVE + 1)?;
        let mut functions = Vec::new();
        let mut targets = Vec::new();
        for (frame, numbers, position, weights) in &asked.targets {
            targets.push(target(numbers, *position, *weights)?);
            functions.extend(self.description.kinematics(frame.as_deref())?);
        }
        // A frame may have several targets.
        functions.sort_unstable();
        functions.dedup();
        let robot = self.with_functions(py, functions)?;
        let places = asked
            .targets
            .iter()
            .map(|(frame, ..)| robot.place(frame.as_deref()));
        let places = places.collect::<Result<Vec<_>, _>>();
        let places = places.map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(py.detach(|| match &places[..] {
            [place] => search(InverseKinematics::new(place), &targets, &asked),
            _ => {
                let frames = places
                    .iter()
                    .map(|place| |q: &DVector<f64>| (place.tip_pose(q), place.tip_jacobian(q)));
                let frames: Vec<_> = frames.collect();
                let Some(first) = places.first() else {
                    return (Vec::new(), Some(("no frame was given".to_owned(), true)));
                };
                search(
                    InverseKinematics::of_frames(first, frames),
                    &targets,
                    &asked,
                )
            }
        }))
    }
}
