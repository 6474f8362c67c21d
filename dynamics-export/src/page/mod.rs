//! An arm as a page that moves: one HTML file with its table, its functions in JavaScript and what shows
//! them.

mod cells;
mod html;
mod literal;
mod start;
mod table;

use crate::javascript::javascript_module;
use crate::poses::poses;
use dynamics_symbolic::robot::{Frame, Robot};
use dynamics_symbolic::{Function, Proven, Request};

pub use start::Start;

use html::html;
use literal::module_with_a_global;

/// The functions that the page evaluates, besides the poses of the tip and of frames.
pub const FUNCTIONS: [Function; 8] = [
    Function::MassMatrix,
    Function::GravityVector,
    Function::FrictionVector,
    Function::SpringVector,
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::KineticEnergy,
    Function::PotentialEnergy,
];

/// The page of a robot.
#[derive(Clone, Debug)]
pub struct Page {
    /// The file.
    pub html: String,
    /// How many bytes of it are the equations.
    pub equations: usize,
}

/// The poses that a page shows: those of the tip and of frames; of a body without any, that of its own frame.
pub fn shown_poses(robot: &mut Robot) -> Vec<Request> {
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

impl Page {
    /// The page of the programs of all [`FUNCTIONS`] and of its [`shown_poses`]. `fields` are
    /// the robot's, each with the value that it has at first.
    pub fn new(
        robot: &Robot,
        programs: &[(Request, Proven)],
        poses: &[Request],
        fields: &[(String, f64)],
        start: &Start,
    ) -> Page {
        let module = javascript_module(robot, programs);
        let equations = module_with_a_global(&module, "robotEquations");
        let tips: Vec<_> = poses.iter().map(|request| request.parts()[0]).collect();
        let table = table::script(robot, &tips, fields, start);
        Page {
            html: html(&robot.name, &equations, &table),
            equations: equations.len(),
        }
    }
}
