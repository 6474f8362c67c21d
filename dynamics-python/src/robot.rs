//! The robot that Python holds.

use std::collections::HashMap;
use std::iter;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use dynamics_evaluation::{JointFriction, ReadOptions, RuntimeRobot, read_text};
use dynamics_symbolic::Request;
use dynamics_symbolic::bounds;
use dynamics_symbolic::emit::{BaseParameters, base_parameter_names};
use dynamics_symbolic::function::plain;
use dynamics_symbolic::robot::{JointType, Row, Value};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

use crate::description::{Derived, Description};
use crate::errors;
use crate::function::Function;

/// A robot that was read, with values of its fields.
#[pyclass(frozen, module = "robot_dynamics._native")]
pub(crate) struct Arm {
    pub(crate) description: Arc<Description>,
    pub(crate) fields: Arc<[f64]>,
    /// Robots of several functions by the places of these, each made when it is first needed.
    robots: Mutex<HashMap<Vec<usize>, Arc<RuntimeRobot>>>,
}

impl Arm {
    fn of(description: Arc<Description>, fields: Arc<[f64]>) -> Self {
        Arm {
            description,
            fields,
            robots: Mutex::default(),
        }
    }

    /// A limit of each joint that moves; infinite where there is none.
    fn greatest(&self, limit: impl Fn(&Row) -> Option<&Value>) -> Vec<f64> {
        let joints = self.description.robot.joints();
        let limits = joints.map(|row| limit(row).map(|limit| limit.to_f64(&self.fields)));
        limits.map(|limit| limit.unwrap_or(f64::INFINITY)).collect()
    }

    /// A function, derived.
    pub(crate) fn derived(&self, py: Python<'_>, function: &str) -> PyResult<&Derived> {
        let place = self.description.place(function)?;
        self.description.derived(py, place)
    }

    /// The robot of some functions, whose fields have the present values.
    pub(crate) fn with_values(&self, robot: &RuntimeRobot) -> PyResult<RuntimeRobot> {
        let mut robot = robot.clone();
        let set = robot.set_fields(&self.fields);
        set.map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        Ok(robot)
    }

    /// The robot with all functions, derived.
    pub(crate) fn all_functions(&self, py: Python<'_>) -> PyResult<Arc<RuntimeRobot>> {
        let places = self.description.functions().map(|(place, _)| place);
        self.with_functions(py, places.collect())
    }

    /// The robot with the functions at these places, derived.
    pub(crate) fn with_functions(
        &self,
        py: Python<'_>,
        places: Vec<usize>,
    ) -> PyResult<Arc<RuntimeRobot>> {
        // A thread that panics does so without the lock.
        let robots = || self.robots.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(robot) = robots().get(&places) {
            return Ok(Arc::clone(robot));
        }
        let programs = places.iter().map(|place| {
            let derived = self.description.derived(py, *place)?;
            Ok((derived.request.clone(), derived.proven.clone()))
        });
        let programs = programs.collect::<PyResult<Vec<_>>>()?;
        let robot = RuntimeRobot::of_programs(self.description.robot.clone(), &programs);
        let robot = robot.map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        let robot = Arc::new(self.with_values(&robot)?);
        Ok(Arc::clone(robots().entry(places).or_insert(robot)))
    }
}

/// The text of a file.
#[pyfunction]
pub(crate) fn text_of(py: Python<'_>, path: PathBuf) -> PyResult<String> {
    read_text(&path).map_err(|error| errors::of_file(py, &error))
}

/// The function by which torques show base parameters.
const REGRESSOR: &str = "regressor";

/// The values of fields that have none yet.
fn without_values(description: &Description) -> Arc<[f64]> {
    vec![f64::NAN; description.robot.fields.len()].into()
}

#[pymethods]
impl Arm {
    /// Reads the text of a file of that name, with entries in TOML and options beside it.
    #[new]
    #[pyo3(signature = (path, text, entries, functions=None, chain=None, ignore=Vec::new(), round_angles=None, fields=None))]
    #[allow(clippy::too_many_arguments)] // They are the options of `ReadOptions`.
    fn new(
        py: Python<'_>,
        path: PathBuf,
        text: &str,
        entries: &str,
        functions: Option<Vec<String>>,
        chain: Option<Vec<String>>,
        ignore: Vec<String>,
        round_angles: Option<f64>,
        fields: Option<Vec<String>>,
    ) -> PyResult<Self> {
        let options = ReadOptions::new().entries(entries).ignore(ignore);
        let mut options = match fields {
            Some(names) => options.fields(names),
            None => options.names_are_fields(),
        };
        if let Some(names) = functions {
            options = options.functions(names);
        }
        if let Some(links) = chain {
            options = options.chain(links);
        }
        if let Some(within) = round_angles {
            options = options.round_angles(within);
        }
        let read = py.detach(|| Description::read(&path, text, &options));
        let description = read.map_err(|error| errors::of_file(py, &error))?;
        description.warn(py)?;
        let fields = without_values(&description);
        Ok(Arm::of(Arc::new(description), fields))
    }

    /// The same robot whose fields have these values.
    fn with_fields(&self, values: Vec<(String, f64)>) -> PyResult<Self> {
        let names = self.field_names();
        let mut fields = self.fields.to_vec();
        for (name, value) in values {
            let place = names.iter().position(|field| *field == name);
            let place = place.ok_or_else(|| {
                let expected = match &names[..] {
                    [] => "the robot has none".to_owned(),
                    names => format!("expected one of {}", names.join(", ")),
                };
                PyValueError::new_err(format!("no field `{name}`: {expected}"))
            })?;
            fields[place] = value;
        }
        Ok(Arm::of(Arc::clone(&self.description), fields.into()))
    }

    /// The robot with these base parameters, and with a friction of `(viscous, Coulomb's of positive velocities, of
    /// negative ones)` for each joint that moves.
    #[pyo3(signature = (base_parameters, friction=None))]
    fn identified(
        &self,
        py: Python<'_>,
        base_parameters: Vec<f64>,
        friction: Option<Vec<[f64; 3]>>,
    ) -> PyResult<Self> {
        let robot = self.with_values(&self.derived(py, REGRESSOR)?.arm)?;
        let found = py.detach(|| match &friction {
            None => robot.identified(&base_parameters),
            Some(friction) => {
                let friction = friction.iter();
                let friction =
                    friction.map(|[viscous, up, down]| JointFriction::new(*viscous, [*up, *down]));
                let friction: Vec<_> = friction.collect();
                robot.identified_with_friction(&base_parameters, &friction)
            }
        });
        let found = found.map_err(|error| PyValueError::new_err(error.to_string()))?;
        let description = self.description.of_robot(found.robot().clone());
        Ok(Arm::of(Arc::new(description), Arc::clone(&self.fields)))
    }

    /// The base parameters nearest to these that bodies can have, and their distance in torque, N m or N.
    fn nearest_possible(
        &self,
        py: Python<'_>,
        base_parameters: Vec<f64>,
    ) -> PyResult<(Vec<f64>, f64)> {
        let robot = self.with_values(&self.derived(py, REGRESSOR)?.arm)?;
        let nearest = py.detach(|| robot.nearest_possible(&base_parameters));
        let nearest = nearest.map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok((nearest.base_parameters, nearest.torque))
    }

    /// The name.
    #[getter]
    fn name(&self) -> &str {
        &self.description.robot.name
    }

    /// Degrees of freedom: the joints that move, and six more of a base that moves.
    #[getter]
    fn dof(&self) -> usize {
        self.description.robot.dof()
    }

    /// Names of the joints that move, from the base outwards.
    #[getter]
    fn joint_names(&self) -> Vec<String> {
        let joints = self.description.robot.joints();
        joints.map(|row| row.name.clone()).collect()
    }

    /// Least and greatest position of each joint that moves, rad or m; infinite where there is no limit.
    #[getter]
    fn joint_limits(&self) -> Vec<[f64; 2]> {
        let joints = self.description.robot.joints();
        let limits = joints.map(|row| match &row.limits {
            Some(limits) => limits.each_ref().map(|limit| limit.to_f64(&self.fields)),
            None => [f64::NEG_INFINITY, f64::INFINITY],
        });
        limits.collect()
    }

    /// The unit of the position of each joint that moves.
    #[getter]
    fn joint_units(&self) -> Vec<&'static str> {
        let joints = self.description.robot.joints();
        let units = joints.map(|row| match row.joint_type {
            JointType::Revolute => "rad",
            JointType::Prismatic => "m",
        });
        units.collect()
    }

    /// Greatest torque or force of each joint that moves, N m or N; infinite where there is no limit.
    #[getter]
    fn torque_limits(&self) -> Vec<f64> {
        self.greatest(|row| row.torque_limit.as_ref())
    }

    /// Greatest velocity of each joint that moves, rad/s or m/s; infinite where there is no limit.
    #[getter]
    fn velocity_limits(&self) -> Vec<f64> {
        self.greatest(|row| row.velocity_limit.as_ref())
    }

    /// The names of the functions, each with the bounds of its rounding errors in double and in single precision.
    fn bounds(&self, py: Python<'_>) -> PyResult<Vec<(String, [f64; 2])>> {
        let robot = &self.description.robot;
        let bound = |(place, request): (usize, &Request)| {
            let proven = &self.description.derived(py, place)?.proven;
            let found = bounds::rounding(robot, request, proven);
            let bound = found.map_or([f64::INFINITY; 2], |found| found.largest());
            Ok((request.name().to_owned(), bound))
        };
        self.description.functions().map(bound).collect()
    }

    /// The first term of each base parameter.
    #[getter]
    fn base_parameter_names(&self) -> Vec<String> {
        base_parameter_names(&self.description.robot)
    }

    /// The base parameters as formulas in the links' own parameters, and the lines that say what the names mean.
    #[getter]
    fn base_parameter_formulas(&self) -> (Vec<String>, Vec<String>) {
        let found = BaseParameters::new(&self.description.robot);
        let legend = iter::once(found.legend);
        (
            found.formulas,
            found.steps.into_iter().chain(legend).collect(),
        )
    }

    /// Names of the fields.
    #[getter]
    fn field_names(&self) -> Vec<String> {
        let names = self.description.robot.fields.iter();
        names.map(|name| plain(name).to_owned()).collect()
    }

    /// Values of the fields, NaN of those without.
    #[getter]
    fn field_values(&self) -> Vec<f64> {
        self.fields.to_vec()
    }

    /// The names of all functions that `functions` knows.
    #[staticmethod]
    fn known_functions() -> Vec<&'static str> {
        let all = dynamics_symbolic::Function::ALL.iter();
        all.map(|function| function.name()).collect()
    }

    /// The functions by their names.
    #[getter]
    fn functions(&self) -> Vec<(String, Function)> {
        let functions = self.description.functions().map(|(place, request)| {
            let function = Function::new(&self.description, place, &self.fields);
            (request.name().to_owned(), function)
        });
        functions.collect()
    }
}
