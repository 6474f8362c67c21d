//! A robot against Newton-Euler, and against another file.

use std::fmt::{Display, Write as _};

use dynamics_evaluation::RuntimeRobot;
use dynamics_symbolic::exact::SplitMix64;
use dynamics_symbolic::function::plain;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Request};

use crate::arguments::Check;
use crate::compare::compare;
use crate::failure::Failure;
use crate::load::{arm, read_both, read_with_names, requests};
use crate::progress::Progress;

/// The text of `check`.
pub(crate) fn run(given: &Check) -> Result<String, Failure> {
    let path = &given.robot.file.path;
    let (model, other) = match &given.against {
        None => (read_with_names(&given.robot)?, None),
        Some(other) => {
            let [model, of_other] = read_both(&given.robot, other, &given.against_chain)?;
            (model, Some((other, of_other)))
        }
    };
    let asked = requests(&model)?;
    let mut checked = arm(path, &model.robot, &asked)?;
    let mut text = numbers_of_its_own(&mut checked)?;
    let check = dynamics_numeric::check::Check::new().samples(given.samples);
    let progress = Progress::new(1);
    progress.doing("comparing with Newton-Euler");
    let report = check.run_any(&checked);
    drop(progress);
    let _ = writeln!(text, "{report}");
    if !report.is_ok() {
        let mut bad = report.functions.iter().filter(|row| !row.is_ok());
        let message = if let Some(first) = bad.next() {
            if first.overflows && bad.all(|row| row.overflows) {
                "the numbers overflow double precision, and nothing can be compared: are the units right?"
            } else {
                "the functions differ from Newton-Euler"
            }
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
    let compared = if given.robot.functions.is_empty() {
        let have_tips = [&model, &other].map(|model| model.robot.tip_row().is_some());
        let mut compared = COMPARED.to_vec();
        compared.retain(|function| !function.row().of_tip || have_tips == [true; 2]);
        let compared: Vec<_> = compared.into_iter().map(Request::from).collect();
        [compared.clone(), compared]
    } else {
        [asked, requests(&other)?]
    };
    if let Some(differs) = freedoms_differ(&model.robot, &other.robot, &path.display()) {
        let message = Failure::of_file(path_of_other, differs).message;
        return Err(Failure::after(text, message));
    }
    let one = arm(path, &model.robot, &compared[0])?;
    let other = arm(path_of_other, &other.robot, &compared[1])?;
    let tolerance = given.tolerance;
    if !compare(&one, &other, given.samples, tolerance, &mut text)? {
        let message = format!("the two files differ by more than {tolerance:e}");
        return Err(Failure::after(text, message));
    }
    Ok(text)
}

/// Gives fields without a value numbers between 0.75 and 1.25, and says so: the equations hold for any.
fn numbers_of_its_own(robot: &mut RuntimeRobot) -> Result<String, Failure> {
    let names = robot.field_names();
    if names.is_empty() {
        return Ok(String::new());
    }
    let mut random = SplitMix64::new(2);
    let mut number = || (750.0 + (500.0 * random.unit()).round()) / 1000.0;
    let values: Vec<f64> = names.iter().map(|_| number()).collect();
    let pairs = names.iter().zip(&values);
    let pairs: Vec<_> = pairs
        .map(|(name, value)| format!("{} = {value}", plain(name)))
        .collect();
    let first = plain(&names[0]).to_owned();
    robot.set_fields(&values)?;
    Ok(format!(
        "fields without a value, which are checked with these numbers (`--field {first}=2` gives another): {}\n",
        pairs.join(", ")
    ))
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
