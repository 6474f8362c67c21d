//! A robot against Newton-Euler, and against another file.

use std::fmt::Display;
use std::path::PathBuf;

use clap::ArgMatches;
use dynamics_runtime::check::Check;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Request};

use crate::compare::compare;
use crate::failure::Failure;
use crate::load::{arm, count, file_of, read_both, read_on_any_base, requests};
use crate::progress::Progress;

/// The text of `check`.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let path = file_of(given);
    let samples = count(given, "samples");
    let other = given.get_one::<PathBuf>("against");
    let (model, other) = match other {
        None => (read_on_any_base(path, given)?, None),
        Some(other) => {
            let [model, of_other] = read_both(other, given)?;
            (model, Some((other, of_other)))
        }
    };
    let asked = requests(&model)?;
    let checked = arm(path, &model.robot, &asked)?;
    let check = Check::new().samples(samples);
    let progress = Progress::new(1);
    progress.doing("comparing with Newton-Euler");
    let report = check.run_any(&checked);
    drop(progress);
    let mut text = format!("{report}\n");
    if !report.is_ok() {
        let differs = report.functions.iter().any(|function| !function.is_ok());
        let message = if differs {
            "the functions differ from Newton-Euler"
        } else if report.has_negative_inertia() {
            "the mass matrix is not positive definite"
        } else {
            "none of the functions can be compared with Newton-Euler: name others too"
        };
        return Err(Failure::after(text, message));
    }
    let Some((path_of_other, other)) = other else {
        return Ok(text);
    };
    let compared = if given.contains_id("functions") {
        [asked, requests(&other)?]
    } else {
        let have_tips = [&model, &other].map(|model| model.robot.tip_row().is_some());
        let mut compared = COMPARED.to_vec();
        compared.retain(|function| !function.row().of_tip || have_tips == [true; 2]);
        let compared: Vec<_> = compared.into_iter().map(Request::from).collect();
        [compared.clone(), compared]
    };
    if let Some(differs) = freedoms_differ(&model.robot, &other.robot, &path.display()) {
        let message = Failure::of_file(path_of_other, differs).message;
        return Err(Failure::after(text, message));
    }
    let one = arm(path, &model.robot, &compared[0])?;
    let other = arm(path_of_other, &other.robot, &compared[1])?;
    let tolerance = given.get_one::<f64>("tolerance").copied().unwrap_or(1e-9);
    if !compare(&one, &other, samples, tolerance, &mut text)? {
        let message = format!("the two files differ by more than {tolerance:e}");
        return Err(Failure::after(text, message));
    }
    Ok(text)
}

/// Why two robots have no states in common: the base of one of them moves, or another number of joints.
fn freedoms_differ(robot: &Robot, other: &Robot, path: &impl Display) -> Option<String> {
    let [of_robot, of_other] = [robot, other].map(Robot::freedoms);
    if of_robot.base != of_other.base {
        let [here, there] = match of_other.has_base() {
            true => ["moves", "stands"],
            false => ["stands", "moves"],
        };
        return Some(format!("the base {here}, and {there} in {path}"));
    }
    let [here, there] = [of_other.joints, of_robot.joints];
    (here != there).then(|| format!("{here} joints move, and {there} in {path}"))
}

/// The functions compared with another file: all that a motion depends on, and the pose of the tip, if both have one.
const COMPARED: [Function; 5] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::InverseDynamics,
    Function::ForwardKinematics,
];
