//! An arm as a page that moves: one HTML file with its table, its functions in JavaScript and what shows
//! them.

mod cells;
mod html;
mod literal;
mod table;

use dynamics_symbolic::emit::javascript_module;
use dynamics_symbolic::robot::{Frame, Robot};
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
    /// The page of the programs of all [`FUNCTIONS`] and of the [`poses`] of the robot. `fields` are the robot's, each with
    /// the value that it has at first.
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

/// The poses that the page shows: of the tip, if there is one, and of all frames. Where there is no tip, each link that
/// carries no other becomes a frame of the robot, unless one stands on it.
pub fn poses(robot: &mut Robot) -> Vec<Request> {
    let of_tip = robot.tip_row().map(|_| Function::ForwardKinematics.into());
    if of_tip.is_none() {
        let is_end = |row: &usize| {
            let carries = (0..robot.rows.len()).any(|other| robot.parent(other) == Some(*row));
            !carries && robot.frames.iter().all(|frame| frame.on != Some(*row))
        };
        let ends = (0..robot.rows.len()).filter(is_end);
        let ends = ends.map(|row| Frame {
            name: robot.rows[row].name.clone(),
            on: Some(row),
            places: Vec::new(),
            body: None,
        });
        let ends: Vec<_> = ends.collect();
        robot.frames.extend(ends);
    }
    let frames = robot.frames.iter().enumerate();
    let mut poses: Vec<Request> = of_tip.into_iter().collect();
    for (index, frame) in frames {
        let pose = Request::of_frame(Function::ForwardKinematics, index, &frame.name);
        // Frames whose names differ in signs alone would be one method.
        if poses.iter().all(|other| other.name() != pose.name()) {
            poses.push(pose);
        }
    }
    poses
}
