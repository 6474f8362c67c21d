//! An arm as a page that moves: one HTML file with its table, its functions in JavaScript and what shows
//! them.

mod cells;
mod html;
mod literal;
mod start;
mod table;

use std::io::Write as _;

use clap::ArgMatches;
use dynamics_symbolic::emit::javascript_module;
use dynamics_symbolic::robot::{Frame, Robot};
use dynamics_symbolic::{Function, Request};

use crate::beside::fields;
use crate::failure::Failure;
use crate::load::{file_of, programs, read_on_any_base, read_with_fields};
use crate::poses::poses;
use html::html;
use literal::module_with_a_global;
use start::Start;

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
    let poses = shown_poses(&mut robot);
    let start = Start::read(given, &robot)?;
    // The values that the fields have at first are judged as those of a file without fields.
    read_on_any_base(path, given)?;
    let requests = FUNCTIONS.map(Request::from).into_iter();
    let requests: Vec<_> = requests.chain(poses.iter().cloned()).collect();
    let programs = programs(path, &robot, &requests)?;
    let module = javascript_module(&robot, &programs);
    let equations = module_with_a_global(&module, "robotEquations");
    let tips: Vec<_> = poses.iter().map(|request| request.parts()[0]).collect();
    let table = table::script(&robot, &tips, &fields(given)?, &start);
    let html = html(&robot.name, &equations, &table);
    if let Some(remark) = remark(html.len(), equations.len(), robot.freedoms().joints) {
        let _ = writeln!(std::io::stderr(), "{remark}");
    }
    Ok(html)
}

/// The poses of the tip and of frames; of a body without any, that of its own frame.
fn shown_poses(robot: &mut Robot) -> Vec<Request> {
    if robot.rows.is_empty() && robot.frames.is_empty() {
        robot.frames.push(Frame {
            name: "base".to_owned(),
            on: None,
            places: Vec::new(),
            body: None,
        });
    }
    poses(robot)
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
