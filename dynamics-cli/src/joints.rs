//! Positions of joints.

use std::io::Write as _;

use dynamics_codegen::{angle_in_degrees, positions_in_degrees};
use dynamics_symbolic::robot::Robot;

/// Remarks on the first angle that was perhaps meant in degrees; whether there is one.
pub(crate) fn note_degrees(source: &str, robot: &Robot, positions: &[f64]) -> bool {
    let remark = positions_in_degrees(robot, positions);
    tell(source, remark.as_deref());
    remark.is_some()
}

/// Remarks on the first of roll, pitch and yaw of a pose that was perhaps meant in degrees.
pub(crate) fn note_degrees_of_pose(angles: [f64; 3]) {
    let mut named = ["ROLL", "PITCH", "YAW"].into_iter().zip(angles);
    let remark = named.find_map(|(name, angle)| angle_in_degrees(name, angle));
    tell("--pose", remark.as_deref());
}

fn tell(source: &str, remark: Option<&str>) {
    if let Some(remark) = remark {
        // A remark that cannot be written is no failure.
        let _ = writeln!(std::io::stderr(), "`{source}`: {remark}");
    }
}
