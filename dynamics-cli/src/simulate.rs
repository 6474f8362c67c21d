//! The motion of an arm.

use dynamics_runtime::nalgebra::{DVector, Dyn};
use dynamics_simulation::simulation::{Cause, DormandPrince, Place, SizedSimulationError};
use dynamics_simulation::{Friction, Simulation};
use dynamics_symbolic::Function;

use crate::arguments::Simulate;
use crate::csv::{put, shortest};
use crate::failure::Failure;
use crate::load::robot_with;
use crate::progress::Progress;
use crate::state::{base, positions, vector};

/// The motion as CSV; the failure of one that ended early.
pub(crate) fn run(given: &Simulate) -> Result<String, Failure> {
    let read = robot_with(&given.robot, Function::default_set(false))?;
    let robot = read.robot();
    let freedoms = [robot.freedoms().base, robot.freedoms().joints];
    let q = positions(&given.from, "from", robot)?;
    let velocity = vector(&given.velocity, "velocity", freedoms)?;
    let torque: DVector<f64> = vector(&given.torque, "torque", freedoms)?.into();
    let place = Place {
        base: base(robot, &given.pose)?,
        q: q.into(),
    };
    let progress = Progress::new(STEPS);
    let in_motion = read.dynamics()?;
    let run = Simulation::new(&in_motion)
        .initial(place, velocity.into())
        .torque(|t, _place, _v| {
            progress.done((t / given.duration * STEPS as f64) as usize);
            torque.clone()
        })
        .method(DormandPrince::with_tolerance(given.tolerance))
        .friction(Friction::Sticking)
        .duration(given.duration)
        .samples(given.samples)
        .run();
    let motion = run.map_err(|error| stopped(error.naming(&in_motion), given))?;
    put(&motion, &in_motion, robot, given.output.plot.as_ref())
}

/// Steps in which progress is shown.
const STEPS: usize = 1000;

/// The failure of a motion that was not followed to its end, and the option to blame.
fn stopped(error: SizedSimulationError<Dyn>, given: &Simulate) -> Failure {
    let time = error.time;
    let duration = given.duration;
    let lost = 16.0 * f64::EPSILON * duration;
    let reason = match error.cause {
        Cause::StepTooSmall if lost > SHORT => format!(
            "`--duration {}`: beside so long a time steps below {lost:.0e} s are lost in rounding, and the motion at \
             t = {} s needs shorter ones: give a shorter time",
            shortest(duration),
            shortest(time)
        ),
        Cause::TooManySteps => format!(
            "`--duration {}`: the motion needs more than {} steps between two samples at t = {} s: give a shorter time, a \
             larger `--tolerance` or more `--samples`; for a stiff robot, Rust and Python have the method of Radau",
            shortest(duration),
            DormandPrince::default().max_steps,
            shortest(time)
        ),
        _ => error.to_string(),
    };
    Failure::after(String::new(), reason)
}

/// Steps of arms are longer, s, unless something is wrong with the motion.
const SHORT: f64 = 1e-9;
