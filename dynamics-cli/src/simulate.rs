//! The motion of an arm.

use clap::ArgMatches;
use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::nalgebra::{DVector, Dyn};
use dynamics_runtime::{
    Friction, Simulation,
    simulation::{Cause, DormandPrince, SizedModel as _, SizedSimulationError},
};
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::Robot;

use crate::csv::{Csv, numbers, shortest};
use crate::failure::Failure;
use crate::joints::note_degrees;
use crate::load::{arm_with, count};
use crate::progress::Progress;

/// The motion as CSV.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let arm = arm_with(given, Function::default_set(false))?;
    let start = Start::of(given, arm.robot())?;
    Ok(motion(&arm, &start, given)?.text())
}

/// Where a motion starts, and what drives it.
struct Start {
    q: Vec<f64>,
    qd: Vec<f64>,
    torque: Vec<f64>,
}

impl Start {
    fn of(given: &ArgMatches, robot: &Robot) -> Result<Start, Failure> {
        Ok(Start {
            q: positions(given, "from", robot)?,
            qd: vector(given, "velocity", robot.dof())?,
            torque: vector(given, "torque", robot.dof())?,
        })
    }
}

/// Steps in which progress is shown.
const STEPS: usize = 1000;

fn motion(arm: &RuntimeRobot, start: &Start, given: &ArgMatches) -> Result<Csv, Failure> {
    let number = |name: &str| given.get_one::<f64>(name).copied().unwrap_or(1.0);
    let [q, qd, torque] =
        [&start.q, &start.qd, &start.torque].map(|entries| DVector::from_column_slice(entries));
    let arm_in_motion = arm.dynamics()?;
    let method = DormandPrince::with_tolerance(number("tolerance"));
    let duration = number("duration");
    let progress = Progress::new(STEPS);
    let motion = Simulation::new(&arm_in_motion)
        .torque(|t, _q, _qd| {
            progress.done((t / duration * STEPS as f64) as usize);
            torque.clone()
        })
        .method(method)
        .friction(Friction::Sticking)
        .initial(q, qd)
        .duration(duration)
        .samples(count(given, "samples"))
        .run()
        .map_err(|error| Failure::after(String::new(), told(&error, duration)))?;
    let mut csv = Csv::new("t", &["q", "qd"], arm.joint_names()).with("energy");
    for ((t, q), qd) in motion.t.iter().zip(&motion.q).zip(&motion.qd) {
        let energies = arm_in_motion.sized_energies(q, qd);
        let energy = energies.map(|[kinetic, potential]| kinetic + potential);
        let entries = q.iter().chain(qd).copied();
        csv.row([*t].into_iter().chain(entries).chain(energy))?;
    }
    Ok(csv)
}

/// Why a motion of so many seconds was not followed to its end, and which option is to blame.
fn told(error: &SizedSimulationError<Dyn>, duration: f64) -> String {
    let lost = 16.0 * f64::EPSILON * duration;
    let reached = error.trajectory.t.last().copied().unwrap_or(0.0);
    match error.cause {
        Cause::StepTooSmall if lost > SHORT => format!(
            "`--duration {}`: beside so long a time steps below {lost:.0e} s are lost in rounding, and the motion at \
             t = {} s asks for shorter ones: give a shorter time",
            shortest(duration),
            shortest(error.time)
        ),
        Cause::TooManySteps => {
            let most = DormandPrince::default().max_steps as f64;
            let step = (error.time - reached) / most;
            format!(
                "`--duration {}`: the motion asks for steps of {step:.0e} s at t = {} s, some {:.0e} up to the end, \
                 and {most:.0e} between two samples are the most: give a shorter time, a larger `--tolerance` or more \
                 `--samples`",
                shortest(duration),
                shortest(error.time),
                (duration - error.time) / step
            )
        }
        _ => error.to_string(),
    }
}

/// Steps of arms are longer, s, unless something is wrong with the motion.
const SHORT: f64 = 1e-9;

/// Positions of the command line, zeros where it has none.
pub(crate) fn positions(
    given: &ArgMatches,
    name: &str,
    robot: &Robot,
) -> Result<Vec<f64>, Failure> {
    let positions = vector(given, name, robot.dof())?;
    note_degrees(&format!("--{name}"), robot, &positions);
    Ok(positions)
}

/// A vector of the command line, zeros where it has none.
fn vector(given: &ArgMatches, name: &str, dof: usize) -> Result<Vec<f64>, Failure> {
    let Some(entries) = given.get_many::<f64>(name) else {
        return Ok(vec![0.0; dof]);
    };
    let entries: Vec<f64> = entries.copied().collect();
    if entries.len() != dof {
        let found = numbers(entries.len());
        let message =
            format!("`--{name}` has {found}: expected {dof}, one for each joint that moves");
        return Err(Failure::of_the_command_line(message));
    }
    Ok(entries)
}
