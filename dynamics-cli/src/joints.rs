//! Positions of joints.

use std::f64::consts::TAU;
use std::io::Write as _;

use dynamics_symbolic::robot::{JointType, Robot};

use crate::csv::shortest;

/// From so many turns on, an angle was perhaps meant in degrees.
const TURNS: f64 = 2.0;

/// Remarks on the first angle that was perhaps meant in degrees; whether there is one.
pub(crate) fn note_degrees(source: &str, robot: &Robot, positions: &[f64]) -> bool {
    let mut joints = robot.joints().zip(positions);
    let many_turns = joints
        .find(|(row, position)| row.joint_type == JointType::Revolute && is_in_degrees(**position));
    if let Some((row, position)) = many_turns {
        remark(source, *position, &row.name);
    }
    many_turns.is_some()
}

/// Remarks on the first of roll, pitch and yaw of a pose that was perhaps meant in degrees.
pub(crate) fn note_degrees_of_pose(angles: [f64; 3]) {
    let mut named = angles.into_iter().zip(["ROLL", "PITCH", "YAW"]);
    if let Some((angle, name)) = named.find(|(angle, _)| is_in_degrees(*angle)) {
        remark("--pose", angle, name);
    }
}

/// Whether an angle was perhaps meant in degrees.
fn is_in_degrees(angle: f64) -> bool {
    angle.abs() > TURNS * TAU
}

/// So many decimals of a number, unless it is astronomic.
fn rounded(x: f64, decimals: usize) -> String {
    if x.abs() < 1e9 {
        format!("{x:.decimals$}")
    } else {
        format!("{x:.1e}")
    }
}

fn remark(source: &str, angle: f64, name: &str) {
    // A remark that cannot be written is no failure.
    let _ = writeln!(
        std::io::stderr(),
        "`{source}`: {} rad of `{name}` are {} turns: angles are in radians, and {} degrees are {}",
        shortest(angle),
        rounded(angle.abs() / TAU, 1),
        shortest(angle),
        rounded(angle.to_radians(), 4)
    );
}
