//! A robot against Newton-Euler, and against another file.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::ArgMatches;
use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::Check;
use dynamics_symbolic::Function;

use crate::failure::Failure;
use crate::joints::with_joints;
use crate::load::{arm, model, model_of};

/// The text of `check`.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let samples = given
        .get_one::<u32>("samples")
        .map_or(100, |samples| *samples as usize);
    let (robot, requests) = model(given)?;
    let arm_of_file = arm(robot.clone(), requests)?;
    let check = Check::new().samples(samples);
    let report = with_joints!(arm_of_file.dof(), N => Ok(check.run(&arm_of_file.typed::<N>()?)))?;
    let mut text = format!("{report}\n");
    if !report.is_ok() {
        return Err(Failure::after(
            text,
            "the functions differ from Newton-Euler",
        ));
    }
    if let Some(path) = given.get_one::<PathBuf>("against") {
        let (other, _) = model_of(path, given)?;
        let tolerance = given.get_one::<f64>("tolerance").copied().unwrap_or(1e-9);
        let [one, other] = [robot, other].map(|robot| {
            arm(
                robot,
                COMPARED.iter().map(|function| (*function).into()).collect(),
            )
        });
        let (one, other) = (one?, other?);
        let is_same = compare(&one, &other, samples, tolerance, &mut text)?;
        if !is_same {
            let message = format!("the two files differ by more than {tolerance:e}");
            return Err(Failure::after(text, message));
        }
    }
    Ok(text)
}

/// What is compared with another file: all that a motion depends on.
const COMPARED: [Function; 4] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::InverseDynamics,
];

/// Compares two arms at random states; whether no difference is too large.
fn compare(
    one: &RuntimeRobot,
    other: &RuntimeRobot,
    samples: usize,
    tolerance: f64,
    text: &mut String,
) -> Result<bool, Failure> {
    let dof = one.dof();
    if dof != other.dof() {
        let message = format!("{} joints move, and {dof} in the first file", other.dof());
        return Err(Failure::after(core::mem::take(text), message));
    }
    let mut random = Random(1);
    let vectors = [3.0, 3.0, 10.0].map(|range| {
        let entries = (0..samples * dof).map(|_| range * random.next());
        entries.collect::<Vec<f64>>()
    });
    let _ = writeln!(
        text,
        "\nagainst the other file: largest difference over the largest entry"
    );
    let mut is_same = true;
    for function in COMPARED {
        let name = function.name();
        let arguments = vectors[..function.arguments().len()].iter();
        let arguments: Vec<&[f64]> = arguments.map(Vec::as_slice).collect();
        let entries = one.entries(name)?;
        let [mut mine, mut others] = [(); 2].map(|()| vec![0.0; samples * entries]);
        one.batch(name, &arguments, &mut mine)?;
        other.batch(name, &arguments, &mut others)?;
        let size = mine.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let differences = mine.iter().zip(&others).map(|(a, b)| (a - b).abs());
        let (place, difference) =
            differences
                .enumerate()
                .fold((0, 0.0_f64), |worst, (place, x)| {
                    if x > worst.1 || x.is_nan() {
                        (place, x)
                    } else {
                        worst
                    }
                });
        let relative = if size > 0.0 {
            difference / size
        } else {
            difference
        };
        let is_good = relative <= tolerance;
        is_same &= is_good;
        let joint = one
            .joint_names()
            .nth(place % entries % dof)
            .unwrap_or_default();
        let at = if is_good {
            String::new()
        } else {
            format!(", most at joint `{joint}`")
        };
        let _ = writeln!(text, "{name:<20} {relative:.1e}{at}");
    }
    Ok(is_same)
}

/// Numbers between -1 and 1, the same each time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        let Random(state) = self;
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
