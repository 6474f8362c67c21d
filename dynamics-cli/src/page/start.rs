//! The motion that a page shows at first.

use clap::ArgMatches;
use dynamics_symbolic::robot::Robot;

use super::literal::{array, number, option};
use crate::failure::Failure;
use crate::state::{positions, refuse_pose, roll_pitch_yaw, vector};

/// Where the motions of a page begin and end. What is left out is for the page to choose.
pub(super) struct Start {
    from: Option<Vec<f64>>,
    to: Option<Vec<f64>>,
    velocity: Option<Vec<f64>>,
    /// Where a base that moves is: position, roll, pitch and yaw.
    pose: Option<[f64; 6]>,
    duration: f64,
}

impl Start {
    pub(super) fn read(given: &ArgMatches, robot: &Robot) -> Result<Start, Failure> {
        let positions_of = |name: &str| {
            let is_given = given.contains_id(name);
            is_given.then(|| positions(given, name, robot)).transpose()
        };
        let freedoms = robot.freedoms();
        let velocity = given
            .contains_id("velocity")
            .then(|| vector(given, "velocity", [freedoms.base, freedoms.joints]));
        if !freedoms.has_base() {
            refuse_pose(given)?;
        }
        Ok(Start {
            from: positions_of("from")?,
            to: positions_of("to")?,
            velocity: velocity.transpose()?,
            pose: roll_pitch_yaw(given)?,
            duration: given.get_one::<f64>("duration").copied().unwrap_or(3.0),
        })
    }

    /// The entries of the page's script.
    pub(super) fn entries(&self) -> [(&'static str, String); 5] {
        let numbers = |values: &[f64]| array(values.iter().copied().map(number));
        let list = |values: &Option<Vec<f64>>| option(values.as_deref().map(numbers));
        [
            ("from", list(&self.from)),
            ("to", list(&self.to)),
            ("velocity", list(&self.velocity)),
            ("pose", option(self.pose.as_ref().map(|pose| numbers(pose)))),
            ("duration", number(self.duration)),
        ]
    }
}
