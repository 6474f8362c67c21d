//! The motion of an arm.

use clap::ArgMatches;
use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::nalgebra::SVector;
use dynamics_runtime::{DormandPrince, Energy as _, Friction, Simulation};
use dynamics_symbolic::{Function, Request};

use crate::csv::Csv;
use crate::failure::Failure;
use crate::joints::with_joints;
use crate::load::{arm, model};

/// The motion as CSV.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let (robot, _) = model(given)?;
    let functions = Function::default_set(false).into_iter().map(Request::One);
    let arm = arm(robot, functions.collect())?;
    let csv = with_joints!(arm.dof(), N => motion::<N>(&arm, given))?;
    csv.put_out(given)
}

fn motion<const N: usize>(arm: &RuntimeRobot, given: &ArgMatches) -> Result<Csv, Failure> {
    let [q, qd, torque] = ["from", "velocity", "torque"].map(|name| vector::<N>(given, name));
    let (q, qd, torque) = (q?, qd?, torque?);
    let number = |name: &str| given.get_one::<f64>(name).copied().unwrap_or(1.0);
    let samples = given
        .get_one::<u32>("samples")
        .map_or(101, |samples| *samples as usize);
    let typed = arm.typed::<N>()?.dynamics()?;
    let method = DormandPrince::with_tolerance(number("tolerance"));
    let motion = Simulation::new(&typed)
        .torque(move |_t, _q, _qd| torque)
        .method(method)
        .friction(Friction::Sticking)
        .initial(q, qd)
        .duration(number("duration"))
        .samples(samples)
        .run()?;
    let mut csv = Csv::new(
        "t",
        &["q", "qd"],
        arm.joint_names().collect::<Vec<_>>().into_iter(),
    )
    .with("energy");
    for ((t, q), qd) in motion.t.iter().zip(&motion.q).zip(&motion.qd) {
        let energy = typed.kinetic_energy(q, qd) + typed.potential_energy(q);
        let entries = q.iter().chain(qd).copied();
        csv.row([*t].into_iter().chain(entries).chain([energy]));
    }
    Ok(csv)
}

/// A vector of the command line, zeros where it has none.
pub(crate) fn vector<const N: usize>(
    given: &ArgMatches,
    name: &str,
) -> Result<SVector<f64, N>, Failure> {
    let Some(entries) = given.get_many::<f64>(name) else {
        return Ok(SVector::zeros());
    };
    let entries: Vec<f64> = entries.copied().collect();
    match <[f64; N]>::try_from(entries) {
        Ok(entries) => Ok(SVector::from(entries)),
        Err(entries) => {
            let found = entries.len();
            let message = format!(
                "`--{name}` has {found} numbers: expected {N}, one for each joint that moves"
            );
            Err(Failure::of_the_command_line(message))
        }
    }
}
