//! An arm as a page that moves: one HTML file with its table, its functions in JavaScript and what shows
//! them.

mod cells;
mod html;
mod literal;
mod table;

use dynamics_symbolic::emit::javascript_module;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Proven, Request};

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

/// The page of a robot whose base stands.
#[derive(Clone, Debug)]
pub struct Page {
    /// The file.
    pub html: String,
    /// How many bytes of it are the equations.
    pub equations: usize,
}

/// The motion that the page shows at first.
#[derive(Clone, Debug)]
pub struct Start {
    /// Positions at its start, rad or m; the page's own where there are none.
    pub from: Option<Vec<f64>>,
    /// Positions at its end.
    pub to: Option<Vec<f64>>,
    /// Its time, s.
    pub duration: f64,
}

impl Page {
    /// The page of the programs of all [`FUNCTIONS`] and of the [`poses`](crate::poses::poses) of the robot. `fields` are
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
