//! An arm as a page that moves: one HTML file with its table, its functions in JavaScript and what shows
//! them.

mod cells;
mod html;
mod literal;
mod table;

use std::io::Write as _;

use clap::ArgMatches;
use dynamics_symbolic::emit::javascript_module;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Request};

use crate::beside::fields;
use crate::failure::Failure;
use crate::load::{file_of, programs, read, read_with_fields};
use crate::poses::poses;
use crate::state::positions;
use html::html;
use literal::module_with_a_global;

/// The functions that the page evaluates, besides the poses of the tip and of frames.
const FUNCTIONS: [Function; 8] = [
    Function::MassMatrix,
    Function::GravityVector,
    Function::FrictionVector,
    Function::SpringVector,
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::KineticEnergy,
    Function::PotentialEnergy,
];

/// The page.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let path = file_of(given);
    let mut robot = read_with_fields(path, given, FUNCTIONS.to_vec())?.robot;
    let poses = poses(&mut robot);
    let start = Start::read(given, &robot)?;
    // The values that the fields have at first are judged as those of a file without fields.
    read(path, given)?;
    let requests = FUNCTIONS.map(Request::from).into_iter();
    let requests: Vec<_> = requests.chain(poses.iter().cloned()).collect();
    let programs = programs(path, &robot, &requests)?;
    let module = javascript_module(&robot, &programs);
    let equations = module_with_a_global(&module, "robotEquations");
    let tips: Vec<_> = poses.iter().map(|request| request.parts()[0]).collect();
    let table = table::script(&robot, &tips, &fields(given)?, &start);
    let html = html(&robot.name, &equations, &table);
    if let Some(remark) = remark(html.len(), equations.len(), robot.dof()) {
        let _ = writeln!(std::io::stderr(), "{remark}");
    }
    Ok(html)
}

/// Bytes up to which a page opens at once on a phone.
const LARGE: usize = 1_000_000;

/// The remark on a page of so many bytes, of which the equations of so many joints take a part.
fn remark(bytes: usize, equations: usize, joints: usize) -> Option<String> {
    let megabytes = |bytes: usize| bytes as f64 / 1e6;
    (bytes > LARGE).then(|| {
        format!(
            "the page has {:.2} MB, {:.2} of them the equations of {joints} joints: it takes a moment to open; \
             joints that stand still are left out of them by `--lock`",
            megabytes(bytes),
            megabytes(equations)
        )
    })
}

/// The motion that the page shows at first.
struct Start {
    from: Option<Vec<f64>>,
    to: Option<Vec<f64>>,
    duration: f64,
}

impl Start {
    fn read(given: &ArgMatches, robot: &Robot) -> Result<Start, Failure> {
        let positions_of = |name: &str| {
            let is_given = given.contains_id(name);
            is_given.then(|| positions(given, name, robot)).transpose()
        };
        Ok(Start {
            from: positions_of("from")?,
            to: positions_of("to")?,
            duration: given.get_one::<f64>("duration").copied().unwrap_or(3.0),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::remark;

    #[test]
    fn large_pages_are_remarked_on() {
        assert_eq!(remark(990_000, 280_000, 12), None);
        let remark = remark(1_234_000, 524_000, 16).unwrap_or_default();
        assert!(
            remark.starts_with("the page has 1.23 MB, 0.52 of them the equations of 16 joints"),
            "{remark}"
        );
    }
}
