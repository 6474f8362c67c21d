//! Positions of joints.

use std::f64::consts::TAU;
use std::io::Write as _;

use dynamics_symbolic::robot::{JointType, Robot};

/// From so many turns on, an angle was perhaps meant in degrees.
const TURNS: f64 = 2.0;

/// Remarks on the first angle that was perhaps meant in degrees; whether there is one.
pub(crate) fn note_degrees(source: &str, robot: &Robot, positions: &[f64]) -> bool {
    let mut joints = robot.joints().zip(positions);
    let many_turns = joints.find(|(row, position)| {
        row.joint_type == JointType::Revolute && position.abs() > TURNS * TAU
    });
    if let Some((row, position)) = many_turns {
        // A remark that cannot be written is no failure.
        let _ = writeln!(
            std::io::stderr(),
            "`{source}`: {position} rad of `{}` are {:.1} turns: angles are in radians, and {position} degrees are {:.4}",
            row.name,
            position.abs() / TAU,
            position.to_radians()
        );
    }
    many_turns.is_some()
}
