//! A robot as it was read, and its functions, each derived when it is first needed.

use std::path::Path;
use std::sync::{Arc, OnceLock, mpsc};
use std::thread;
use std::time::Duration;

use dynamics_codegen::{Model, nearest};
use dynamics_evaluation::{BuildError, FileError, ReadOptions, RuntimeRobot, read_source};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Proven, Request, proven_program};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

use crate::errors::warn;

/// How often a derivation that runs is interrupted for signals such as Ctrl-C.
const BETWEEN_SIGNALS: Duration = Duration::from_millis(50);

/// The stack of a derivation, as the main thread of a program has it.
const STACK: usize = 8 << 20;

/// The calls of the package from this one out to the user's of `Robot.from_file` and its sisters.
const CALLS_TO_FROM_FILE: i32 = 5;

/// A robot and the functions that were requested.
pub(crate) struct Description {
    pub(crate) robot: Robot,
    functions: Vec<Lazy>,
    /// Notes on values of the file that its reader may not expect.
    warnings: Vec<String>,
}

/// A function that is derived when it is first needed.
struct Lazy {
    request: Request,
    derived: OnceLock<Result<Derived, String>>,
}

/// A function, derived and proven.
pub(crate) struct Derived {
    pub(crate) request: Request,
    pub(crate) proven: Proven,
    /// The robot with this function alone, whose fields have no value.
    pub(crate) arm: Arc<RuntimeRobot>,
}

impl Description {
    /// Reads the text of a file of that name.
    pub(crate) fn read(path: &Path, text: &str, options: &ReadOptions) -> Result<Self, FileError> {
        let Model {
            robot,
            requests,
            warnings,
            ..
        } = read_source(path, text, options)?;
        let warnings: Vec<_> = warnings.into_iter().map(|found| found.message).collect();
        let requests: Vec<_> = requests.into_iter().map(|(request, _)| request).collect();
        if !robot.freedoms().has_base() && robot.freedoms().joints == 0 {
            return Err(FileError::Build(path.to_owned(), BuildError::NoJoints));
        }
        Ok(Description {
            warnings,
            ..Description::new(robot, requests)
        })
    }

    /// A `UserWarning` for each thing that the reader of the file may not expect, where `Robot.from_file` was called.
    pub(crate) fn warn(&self, py: Python<'_>) -> PyResult<()> {
        for warning in &self.warnings {
            // Notes are in the words of a call of the macro.
            let text = warning.trim().replace("`round_angles: ", "`round_angles=");
            warn(py, &text, CALLS_TO_FROM_FILE)?;
        }
        Ok(())
    }

    /// Functions of a robot.
    pub(crate) fn new(robot: Robot, requests: impl IntoIterator<Item = Request>) -> Self {
        let functions = requests.into_iter().map(|request| Lazy {
            request,
            derived: OnceLock::new(),
        });
        Description {
            robot,
            functions: functions.collect(),
            warnings: Vec::new(),
        }
    }

    /// The same functions of another robot.
    pub(crate) fn of_robot(&self, robot: Robot) -> Self {
        let requests = self.functions.iter().map(|lazy| lazy.request.clone());
        Description::new(robot, requests)
    }

    /// The function at that place.
    pub(crate) fn request(&self, place: usize) -> &Request {
        &self.functions[place].request
    }

    /// The functions that are programs over numbers, each by its place.
    pub(crate) fn functions(&self) -> impl Iterator<Item = (usize, &Request)> {
        let is_program =
            |(_, request): &(usize, &Request)| request.function() != Some(Function::TaylorSeries);
        let requests = self.functions.iter().map(|lazy| &lazy.request);
        requests.enumerate().filter(is_program)
    }

    /// The place of the function of that name.
    pub(crate) fn place(&self, name: &str) -> PyResult<usize> {
        let found = self.functions().find(|(_, request)| request.name() == name);
        found.map(|(place, _)| place).ok_or_else(|| {
            let names: Vec<_> = self.functions().map(|(_, of)| of.name()).collect();
            PyValueError::new_err(format!(
                "`{name}` is not in `functions`: expected one of {}",
                names.join(", ")
            ))
        })
    }

    /// The places of the two functions by which a frame, or the tip, is found: its pose and its Jacobian.
    pub(crate) fn kinematics(&self, frame: Option<&str>) -> PyResult<[usize; 2]> {
        let frames: Vec<_> = self
            .robot
            .frames
            .iter()
            .map(|of| of.name.as_str())
            .collect();
        if let Some(name) = frame.filter(|name| !frames.contains(name)) {
            let hint = match (nearest(name, &frames), &frames[..]) {
                (Some(right), _) => format!("did you mean `{right}`?"),
                (None, []) => format!(
                    "there are none (a link of a URDF file is one if `functions` names it: \"jacobian({name})\")"
                ),
                (None, frames) => format!("expected one of {}", frames.join(", ")),
            };
            return Err(PyValueError::new_err(format!("no frame `{name}`: {hint}")));
        }
        if frame.is_none() && self.robot.tip_row().is_none() {
            let names = match &frames[..] {
                [] => "make one on a link".to_owned(),
                frames => format!("there are {}", frames.join(", ")),
            };
            let message =
                format!("the robot has no tip, but several ends: name a frame instead, {names}");
            return Err(PyValueError::new_err(message));
        }
        let methods = RuntimeRobot::place_methods(frame);
        match methods.each_ref().map(|name| self.place(name)) {
            [Ok(pose), Ok(jacobian)] => Ok([pose, jacobian]),
            _ => {
                let [pose, jacobian] = RuntimeRobot::place_functions(frame);
                Err(PyValueError::new_err(format!(
                    "{} needs functions that are not requested: functions=[\"default\", \"{pose}\", \"{jacobian}\"]",
                    frame.map_or_else(|| "the tip".to_owned(), |frame| format!("frame `{frame}`")),
                )))
            }
        }
    }

    /// The function at that place, which is derived if this has not been done.
    pub(crate) fn derived(self: &Arc<Self>, py: Python<'_>, place: usize) -> PyResult<&Derived> {
        let slot = &self.functions[place].derived;
        if slot.get().is_none() {
            self.derive_beside(py, place)?;
        }
        match slot.get() {
            Some(Ok(derived)) => Ok(derived),
            Some(Err(reason)) => Err(PyRuntimeError::new_err(reason.clone())),
            None => Err(PyRuntimeError::new_err("the derivation has failed")),
        }
    }

    /// Derives on a thread of its own, so that signals are heard meanwhile. After Ctrl-C it goes on in the background.
    fn derive_beside(self: &Arc<Self>, py: Python<'_>, place: usize) -> PyResult<()> {
        let (end, mut ended) = mpsc::channel::<()>();
        let this = Arc::clone(self);
        thread::Builder::new().stack_size(STACK).spawn(move || {
            let lazy = &this.functions[place];
            lazy.derived.get_or_init(|| this.derive(&lazy.request));
            drop(end);
        })?;
        loop {
            let waited;
            (ended, waited) = py.detach(move || {
                let waited = ended.recv_timeout(BETWEEN_SIGNALS);
                (ended, waited)
            });
            if waited == Err(mpsc::RecvTimeoutError::Disconnected) {
                return Ok(());
            }
            py.check_signals()?;
        }
    }

    /// The programs of all functions.
    pub(crate) fn programs(self: &Arc<Self>, py: Python<'_>) -> PyResult<Vec<(Request, Proven)>> {
        let programs = (0..self.functions.len()).map(|place| {
            let derived = self.derived(py, place)?;
            Ok((derived.request.clone(), derived.proven.clone()))
        });
        programs.collect()
    }

    fn derive(&self, request: &Request) -> Result<Derived, String> {
        let proven = proven_program(&self.robot, request).map_err(|failure| failure.to_string())?;
        let programs = [(request.clone(), proven)];
        let arm = RuntimeRobot::of_programs(self.robot.clone(), &programs);
        let arm = arm.map_err(|error| error.to_string())?;
        let [(request, proven)] = programs;
        Ok(Derived {
            request: self.robot.request(request),
            proven,
            arm: Arc::new(arm),
        })
    }
}
