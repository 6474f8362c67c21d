//! An arm as a page that moves: one HTML file with its table, its functions in JavaScript and what shows
//! them.

mod cells;
mod html;
mod literal;
mod table;

use clap::ArgMatches;
use dynamics_symbolic::emit::javascript_module;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Request};

use crate::failure::Failure;
use crate::load::{fields, file_of, programs, read};
use crate::simulate::vector;
use html::Page;
use literal::module_with_a_global;

/// What the page evaluates.
const FUNCTIONS: [Function; 9] = [
    Function::MassMatrix,
    Function::GravityVector,
    Function::FrictionVector,
    Function::SpringVector,
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::KineticEnergy,
    Function::PotentialEnergy,
    Function::ForwardKinematics,
];

/// The page.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let path = file_of(given);
    let robot = read(path, given)?.robot;
    let start = Start::of(given, &robot)?;
    let programs = programs(path, &robot, &FUNCTIONS.map(Request::One))?;
    let page = Page {
        name: &robot.name,
        equations: module_with_a_global(&javascript_module(&robot, &programs), "robotEquations"),
        table: table::script(&robot, &fields(given)?, &start),
    };
    Ok(page.html())
}

/// What the page shows at first.
struct Start {
    from: Option<Vec<f64>>,
    to: Option<Vec<f64>>,
    duration: f64,
}

impl Start {
    fn of(given: &ArgMatches, robot: &Robot) -> Result<Start, Failure> {
        let positions = |name: &str| {
            let is_given = given.contains_id(name);
            is_given
                .then(|| vector(given, name, robot.dof()))
                .transpose()
        };
        Ok(Start {
            from: positions("from")?,
            to: positions("to")?,
            duration: given.get_one::<f64>("duration").copied().unwrap_or(3.0),
        })
    }
}
