//! The motion of an arm.

use std::fmt::Display;

use clap::ArgMatches;
use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::nalgebra::{DVector, Rotation3, Vector3};
use dynamics_runtime::simulation::{Cause, DormandPrince};
use dynamics_runtime::{Friction, Pose, Simulation};
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::Robot;

use crate::csv::{shortest, too_large, written};
use crate::failure::Failure;
use crate::joints::note_degrees;
use crate::load::{count, robot_with};
use crate::progress::Progress;

/// The motion as CSV.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let robot = robot_with(given, Function::default_set(false))?;
    let start = Start::read(given, robot.robot())?;
    if robot.robot().floating().is_some() {
        return motion_on_base(&robot, &start, given);
    }
    if given.contains_id("pose") {
        let message = "`--pose` is of a robot whose base moves: this one stands";
        return Err(Failure::of_the_command_line(message));
    }
    motion(&robot, &start, given)
}

/// Where a motion starts, and what drives it.
struct Start {
    q: DVector<f64>,
    velocity: DVector<f64>,
    torque: DVector<f64>,
}

impl Start {
    fn read(given: &ArgMatches, robot: &Robot) -> Result<Start, Failure> {
        let freedoms = robot.freedoms();
        let freedoms = [freedoms.base, freedoms.joints];
        Ok(Start {
            q: positions(given, "from", robot)?.into(),
            velocity: vector(given, "velocity", freedoms)?.into(),
            torque: vector(given, "torque", freedoms)?.into(),
        })
    }
}

/// Steps in which progress is shown.
const STEPS: usize = 1000;

/// A number that has a default.
fn number(given: &ArgMatches, name: &str) -> f64 {
    given.get_one::<f64>(name).copied().unwrap_or(1.0)
}

fn motion(arm: &RuntimeRobot, start: &Start, given: &ArgMatches) -> Result<String, Failure> {
    let arm_in_motion = arm.dynamics()?;
    let duration = number(given, "duration");
    let progress = Progress::new(STEPS);
    let motion = Simulation::new(&arm_in_motion)
        .torque(|t, _q, _qd| {
            progress.done((t / duration * STEPS as f64) as usize);
            start.torque.clone()
        })
        .method(DormandPrince::with_tolerance(number(given, "tolerance")))
        .friction(Friction::Sticking)
        .initial(start.q.clone(), start.velocity.clone())
        .duration(duration)
        .samples(count(given, "samples"))
        .run()
        .map_err(|error| {
            let reached = error.trajectory.t.last().copied();
            let end = (error.time, reached.unwrap_or(0.0));
            failed(explanation(&error, error.cause, end, duration))
        })?;
    written(&motion, &arm_in_motion)
}

/// The motion on a base that moves.
fn motion_on_base(
    robot: &RuntimeRobot,
    start: &Start,
    given: &ArgMatches,
) -> Result<String, Failure> {
    let in_motion = robot.dynamics_on_base()?;
    let duration = number(given, "duration");
    let progress = Progress::new(STEPS);
    let motion = Simulation::new(&in_motion)
        .torque(|t, _base, _q, _v| {
            progress.done((t / duration * STEPS as f64) as usize);
            start.torque.clone()
        })
        .method(DormandPrince::with_tolerance(number(given, "tolerance")))
        .friction(Friction::Sticking)
        .initial(pose(given)?, start.q.clone(), start.velocity.clone())
        .duration(duration)
        .samples(count(given, "samples"))
        .run()
        .map_err(|error| {
            let reached = error.trajectory.t.last().copied();
            let end = (error.time, reached.unwrap_or(0.0));
            failed(explanation(&error, error.cause, end, duration))
        })?;
    let energies = motion.energies(&in_motion);
    if let Some(k) = energies.iter().position(|energy| !energy.is_finite()) {
        return Err(failed(too_large("energy", motion.t[k])));
    }
    let mut text = Vec::new();
    motion.write_csv(&in_motion, &mut text)?;
    Ok(String::from_utf8(text)?)
}

/// The pose of `--pose`: roll, pitch and yaw are turns about the fixed axes x, y and z, one after the other.
fn pose(given: &ArgMatches) -> Result<Pose<f64>, Failure> {
    let Some(entries) = given.get_many::<f64>("pose") else {
        return Ok(Pose::identity());
    };
    let entries: Vec<f64> = entries.copied().collect();
    let [x, y, z, roll, pitch, yaw] = entries[..] else {
        let message = format!(
            "`--pose` has {} numbers: expected six, X,Y,Z,ROLL,PITCH,YAW",
            entries.len()
        );
        return Err(Failure::of_the_command_line(message));
    };
    Ok(Pose {
        rotation: Rotation3::from_euler_angles(roll, pitch, yaw).into_inner(),
        position: Vector3::new(x, y, z),
    })
}

fn failed(reason: String) -> Failure {
    Failure::after(String::new(), reason)
}

/// The reason why a motion of so many seconds was not followed to its end, and the option to blame.
fn explanation(
    error: &dyn Display,
    cause: Cause,
    (time, reached): (f64, f64),
    duration: f64,
) -> String {
    let lost = 16.0 * f64::EPSILON * duration;
    match cause {
        Cause::StepTooSmall if lost > SHORT => format!(
            "`--duration {}`: beside so long a time steps below {lost:.0e} s are lost in rounding, and the motion at \
             t = {} s asks for shorter ones: give a shorter time",
            shortest(duration),
            shortest(time)
        ),
        Cause::TooManySteps => {
            let most = DormandPrince::default().max_steps as f64;
            let step = (time - reached) / most;
            format!(
                "`--duration {}`: the motion asks for steps of {step:.0e} s at t = {} s, some {:.0e} up to the end, \
                 and {most:.0e} between two samples are the most: give a shorter time, a larger `--tolerance` or more \
                 `--samples`",
                shortest(duration),
                shortest(time),
                (duration - time) / step
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
    let positions = vector(given, name, [0, robot.freedoms().joints])?;
    note_degrees(&format!("--{name}"), robot, &positions);
    Ok(positions)
}

/// A vector of the command line, with so many numbers of the base and of the joints; zeros where it has none.
fn vector(given: &ArgMatches, name: &str, [base, joints]: [usize; 2]) -> Result<Vec<f64>, Failure> {
    let expected = base + joints;
    let Some(entries) = given.get_many::<f64>(name) else {
        return Ok(vec![0.0; expected]);
    };
    let entries: Vec<f64> = entries.copied().collect();
    if entries.len() != expected {
        let found = entries.len();
        let plural = if found == 1 { "" } else { "s" };
        let of_base = if base > 0 {
            "six of the base, then "
        } else {
            ""
        };
        let message = format!(
            "`--{name}` has {found} number{plural}: expected {expected}, {of_base}one for each joint that moves"
        );
        return Err(Failure::of_the_command_line(message));
    }
    Ok(entries)
}
