//! The motion of an arm.

use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::nalgebra::{DVector, Dyn};
use dynamics_runtime::simulation::{
    Cause, DormandPrince, EquationsOfMotion, SizedModel, SizedSimulationError, SizedTrajectory,
    Stand,
};
use dynamics_runtime::{Friction, Simulation};
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::Robot;

use crate::arguments::Simulate;
use crate::csv::{put, shortest};
use crate::failure::Failure;
use crate::load::robot_with;
use crate::progress::Progress;
use crate::state::{pose, positions, refuse_pose, vector};

/// The motion as CSV.
pub(crate) fn run(given: &Simulate) -> Result<String, Failure> {
    let robot = robot_with(&given.robot, Function::default_set(false))?;
    let Start {
        q,
        velocity,
        torque,
    } = Start::read(given, robot.robot())?;
    let duration = given.duration;
    let progress = Progress::new(STEPS);
    let torque = |t: f64| {
        progress.done((t / duration * STEPS as f64) as usize);
        torque.clone()
    };
    if robot.robot().floating().is_some() {
        let in_motion = robot.dynamics_on_base()?;
        let motion = Simulation::new(&in_motion)
            .torque(|t, _base, _q, _v| torque(t))
            .initial(pose(&given.pose)?, q, velocity);
        return told(planned(motion, given).run(), &in_motion, &robot, given);
    }
    refuse_pose(&given.pose)?;
    let in_motion = robot.dynamics()?;
    let motion = Simulation::new(&in_motion)
        .torque(|t, _q, _qd| torque(t))
        .initial(q, velocity);
    told(planned(motion, given).run(), &in_motion, &robot, given)
}

/// Where a motion starts, and what drives it.
struct Start {
    q: DVector<f64>,
    velocity: DVector<f64>,
    torque: DVector<f64>,
}

impl Start {
    fn read(given: &Simulate, robot: &Robot) -> Result<Start, Failure> {
        let freedoms = robot.freedoms();
        let freedoms = [freedoms.base, freedoms.joints];
        Ok(Start {
            q: positions(&given.from, "from", robot)?.into(),
            velocity: vector(&given.velocity, "velocity", freedoms)?.into(),
            torque: vector(&given.torque, "torque", freedoms)?.into(),
        })
    }
}

/// Steps in which progress is shown.
const STEPS: usize = 1000;

/// A simulation with the settings of the command line.
fn planned<'a, R: SizedModel<K> + EquationsOfMotion<K>, L, W, S, K: Stand>(
    simulation: Simulation<'a, R, L, K, W, S>,
    given: &Simulate,
) -> Simulation<'a, R, L, K, W, S> {
    simulation
        .method(DormandPrince::with_tolerance(given.tolerance))
        .friction(Friction::Sticking)
        .duration(given.duration)
        .samples(given.samples)
}

/// A run as a table, and as a figure where one is requested; the failure of one that ended early.
fn told<K: Stand<Joints = Dyn, Freedoms = Dyn>>(
    run: Result<SizedTrajectory<K>, Box<SizedSimulationError<K>>>,
    in_motion: &impl SizedModel<K>,
    robot: &RuntimeRobot,
    given: &Simulate,
) -> Result<String, Failure> {
    let motion = run.map_err(|error| stopped(error.naming(in_motion), given))?;
    put(
        &motion,
        in_motion,
        robot.robot(),
        given.output.plot.as_ref(),
    )
}

/// The failure of a motion that was not followed to its end, and the option to blame.
fn stopped<K: Stand>(error: SizedSimulationError<K>, given: &Simulate) -> Failure {
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
