//! Simulations, under torques that are constant or a law of Python.

use dynamics_evaluation::{EvaluationError, RuntimeDynamics, RuntimeRobot};
use dynamics_runtime::nalgebra::{DVector, Dyn};
use dynamics_simulation::simulation::{
    Cause, Dop853, DormandPrince, FreeMotion, Method, Place, Radau5, SizedSimulationError,
    SizedTrajectory, Work,
};
use dynamics_simulation::{Friction, Simulation};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arguments::require_transform;
use crate::errors::warn_of_degrees;
use crate::force::{Force, Wrench};
use crate::pose::{by_rows, pose_of};
use crate::results::array;
use crate::robot::Arm;

/// A run that is requested.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Plan {
    /// The pose of a base that moves, a homogeneous matrix by rows.
    base: Option<[f64; 16]>,
    q: Vec<f64>,
    v: Vec<f64>,
    duration: f64,
    samples: usize,
    method: String,
    step: Option<f64>,
    tolerance: Option<f64>,
    max_step: Option<f64>,
    max_steps: Option<usize>,
    friction: String,
    speed: f64,
    saturate: bool,
    stops: Option<f64>,
    limits_are_errors: bool,
    control_period: Option<f64>,
    /// The forces of the surroundings.
    wrenches: Vec<Wrench>,
    /// The force at the tool that is held for the control period.
    held_wrench: Option<Wrench>,
}

/// A motion: one entry a sample.
#[derive(Default)]
struct Motion {
    t: Vec<f64>,
    base: Vec<f64>,
    q: Vec<DVector<f64>>,
    v: Vec<DVector<f64>>,
    a: Vec<DVector<f64>>,
    tau: Vec<DVector<f64>>,
    energies: Vec<[f64; 2]>,
    work: Work,
    /// The joints that crept.
    creeping: Vec<usize>,
}

/// How a run ended early: the time, the reason, and whether a setting makes no sense.
type Stopped = (f64, String, bool);

impl Plan {
    fn method(&self) -> PyResult<Method> {
        let refused = |name: &str, way_out: &str| {
            let message = format!("`method` {:?} has no `{name}`: {way_out}", self.method);
            Err(PyValueError::new_err(message))
        };
        let controls = [
            ("tolerance", self.tolerance.is_some()),
            ("max_step", self.max_step.is_some()),
            ("max_steps", self.max_steps.is_some()),
        ];
        let is_controlled = matches!(&*self.method, "dormand_prince" | "dop853" | "radau5");
        if is_controlled && self.step.is_some() {
            return refused("step", "it chooses its steps, which `max_step` bounds");
        }
        if let Some((name, _)) = controls.iter().find(|(_, given)| *given && !is_controlled) {
            return refused(name, "all of its steps have the length `step`");
        }
        let step = || {
            self.step.ok_or_else(|| {
                let message = format!(
                    "`method` {:?} has steps of one length: `step` is missing",
                    self.method
                );
                PyValueError::new_err(message)
            })
        };
        macro_rules! controlled {
            ($settings:ident) => {{
                let tolerance = self.tolerance.map($settings::with_tolerance);
                let mut settings = tolerance.unwrap_or_default();
                settings.max_step = self.max_step.or(settings.max_step);
                settings.max_steps = self.max_steps.unwrap_or(settings.max_steps);
                Method::from(settings)
            }};
        }
        Ok(match self.method.as_str() {
            "explicit_euler" => Method::ExplicitEuler { step: step()? },
            "craig_euler" => Method::CraigEuler { step: step()? },
            "semi_implicit_euler" => Method::SemiImplicitEuler { step: step()? },
            "runge_kutta4" => Method::RungeKutta4 { step: step()? },
            "implicit_midpoint" => Method::ImplicitMidpoint { step: step()? },
            "gauss_legendre4" => Method::GaussLegendre4 { step: step()? },
            "gauss_legendre6" => Method::GaussLegendre6 { step: step()? },
            "dormand_prince" => controlled!(DormandPrince),
            "dop853" => controlled!(Dop853),
            "radau5" => controlled!(Radau5),
            "taylor" => {
                return Err(PyValueError::new_err(
                    "`method` \"taylor\" is of compiled robots, `TaylorSimulation` in Rust: its series have a program of their own, \
                     which only a compiler makes fast; \"dop853\" with `tolerance=1e-12` is accurate too",
                ));
            }
            other => {
                return Err(PyValueError::new_err(format!(
                    "`method` is {other:?}: expected dormand_prince, dop853 or radau5, or explicit_euler, craig_euler, \
                     semi_implicit_euler, runge_kutta4, implicit_midpoint, gauss_legendre4 or gauss_legendre6 with a `step`"
                )));
            }
        })
    }

    fn friction(&self) -> PyResult<Friction> {
        let speed = self.speed;
        match self.friction.as_str() {
            "sign" => Ok(Friction::Sign),
            "sticking" => Ok(Friction::Sticking),
            "regularised" => Ok(Friction::Regularised { speed }),
            other => Err(PyValueError::new_err(format!(
                "`friction` is {other:?}: expected \"sign\", \"sticking\" or \"regularised\""
            ))),
        }
    }

    /// The simulation with all settings but its laws.
    fn planned<'a>(
        &self,
        dynamics: &'a RuntimeDynamics<'a>,
        (method, friction): (Method, Friction),
    ) -> Simulation<'a, RuntimeDynamics<'a>, FreeMotion, Dyn> {
        let [q, v] = [&self.q, &self.v].map(|x| DVector::from_column_slice(x));
        let base = self.base.as_ref().map(|rows| pose_of(rows));
        let mut simulation = Simulation::new(dynamics)
            .initial(Place { base, q }, v)
            .method(method)
            .friction(friction)
            .duration(self.duration)
            .samples(self.samples);
        if self.saturate {
            simulation = simulation.saturate();
        }
        if let Some(restitution) = self.stops {
            simulation = simulation.stops(restitution);
        }
        if self.limits_are_errors {
            simulation = simulation.limits_are_errors();
        }
        simulation
    }
}

/// The outcome of a run: its samples, and how it stopped where that was before its end.
type Ran = Result<(Motion, Option<Stopped>), EvaluationError>;

/// The motion of a robot under its laws.
fn moved(robot: &RuntimeRobot, plan: &Plan, kinds: (Method, Friction), force: &Force) -> Ran {
    let dynamics = robot.dynamics()?;
    let mut simulation = plan.planned(&dynamics, kinds);
    for wrench in &plan.wrenches {
        let frame = robot.place(wrench.frame.as_deref())?;
        simulation = simulation.wrench_at(
            move |_, place| frame.at(place),
            |t, pose, twist| force.wrench(wrench, t, pose, twist),
        );
    }
    let law = |t, place: &Place<Dyn>, v: &DVector<f64>| force.at(t, place, v);
    let outcome = match plan.control_period {
        None => simulation.torque(law).run(),
        Some(period) => {
            let mut simulation = simulation.control_period(period);
            if let Some(held) = &plan.held_wrench {
                let frame = robot.place(held.frame.as_deref())?;
                simulation = simulation.held_wrench_at(
                    move |_, place| frame.at(place),
                    |t, pose, twist| force.wrench(held, t, pose, twist),
                );
            }
            simulation.torque(law).run()
        }
    };
    Ok(ran(&dynamics, outcome))
}

/// The samples of a run, with their energies; the poses of a base that moves by rows.
fn ran(
    dynamics: &RuntimeDynamics<'_>,
    outcome: Result<SizedTrajectory<Dyn>, Box<SizedSimulationError<Dyn>>>,
) -> (Motion, Option<Stopped>) {
    let (motion, stopped) = match outcome {
        Ok(motion) => (motion, None),
        Err(error) => {
            let error = error.naming(dynamics);
            let is_invalid = matches!(error.cause, Cause::InvalidSetting(_));
            let stopped = (error.time, error.to_string(), is_invalid);
            (error.trajectory, Some(stopped))
        }
    };
    let of_base = if motion.base.is_empty() { 0 } else { 6 };
    let motion = Motion {
        base: motion.base.iter().flat_map(by_rows).collect(),
        energies: motion.both_energies(dynamics).flatten().collect(),
        t: motion.t,
        q: motion.q,
        v: motion.qd,
        a: motion.qdd,
        tau: motion.tau,
        work: motion.work,
        // Behind the freedoms of a base that moves.
        creeping: motion
            .creeping
            .iter()
            .filter_map(|joint| joint.checked_sub(of_base))
            .collect(),
    };
    (motion, stopped)
}

impl Motion {
    fn arrays<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let samples = self.t.len();
        let arrays = PyDict::new(py);
        arrays.set_item("t", array(py, &[samples], &self.t)?)?;
        if !self.base.is_empty() {
            arrays.set_item("base", array(py, &[samples, 4, 4], &self.base)?)?;
        }
        let vectors = [
            ("q", &self.q),
            ("v", &self.v),
            ("a", &self.a),
            ("tau", &self.tau),
        ];
        for (name, vectors) in vectors {
            let width = vectors.first().map_or(0, DVector::len);
            let flat: Vec<f64> = vectors.iter().flat_map(|x| x.iter().copied()).collect();
            arrays.set_item(name, array(py, &[vectors.len(), width], &flat)?)?;
        }
        let energies = self.energies.as_flattened();
        arrays.set_item("energies", array(py, &[self.energies.len(), 2], energies)?)?;
        let Work {
            evaluations,
            steps,
            rejected,
            ..
        } = self.work;
        arrays.set_item("work", (evaluations, steps, rejected))?;
        arrays.set_item("creeping", self.creeping.clone())?;
        Ok(arrays)
    }
}

/// The calls of the package from this one out to the user's of `Robot.simulate`; one more to that of `Robot.reach`.
pub(crate) const CALLS_TO_MOVE: i32 = 3;

#[pymethods]
impl Arm {
    /// Follows a motion. Arrays of its samples, and how it stopped where that was before its end: the time, the reason, and
    /// whether a setting makes no sense.
    fn simulate<'py>(
        &self,
        py: Python<'py>,
        plan: Plan,
        law: Option<Py<PyAny>>,
        constant: Vec<f64>,
    ) -> PyResult<(Bound<'py, PyDict>, Option<Stopped>)> {
        let kinds = (plan.method()?, plan.friction()?);
        if let Some(base) = &plan.base {
            require_transform("base", base)?;
        }
        for wrench in plan.wrenches.iter().chain(&plan.held_wrench) {
            self.description.kinematics(wrench.frame.as_deref())?;
        }
        warn_of_degrees(py, &self.description.robot, &plan.q, CALLS_TO_MOVE)?;
        let robot = self.all_functions(py)?;
        let force = Force::new(law, constant);
        let plan = &plan;
        let (ran, force) = py.detach(move || {
            let ran = moved(&robot, plan, kinds, &force);
            (ran, force)
        });
        if let Some(failure) = force.into_failure() {
            return Err(failure);
        }
        let (motion, stopped) = ran.map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok((motion.arrays(py)?, stopped))
    }
}
