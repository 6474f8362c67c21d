//! Angles that were perhaps meant in degrees.

use std::f64::consts::TAU;

use dynamics_symbolic::robot::{JointType, Robot};

use crate::words::number;

/// From so many turns on, an angle was perhaps meant in degrees.
const TURNS: f64 = 2.0;

/// A remark on the first position of a joint that was perhaps meant in degrees.
pub fn positions_in_degrees(robot: &Robot, positions: &[f64]) -> Option<String> {
    let mut joints = robot
        .joints()
        .zip(positions)
        .filter(|(row, _)| row.joint_type == JointType::Revolute);
    joints.find_map(|(row, position)| angle_in_degrees(&row.name, *position))
}

/// A remark on an angle if it was perhaps meant in degrees.
pub fn angle_in_degrees(name: &str, angle: f64) -> Option<String> {
    // An angle that is not finite is refused elsewhere, or propagates.
    (angle.abs() > TURNS * TAU && angle.is_finite()).then(|| {
        let shown = number(angle);
        format!(
            "{shown} rad of `{name}` are {} turns: angles are in radians, and {shown} degrees are {}",
            rounded(angle.abs() / TAU, 1),
            rounded(angle.to_radians(), 4)
        )
    })
}

/// So many decimals of a number, unless it is astronomic.
fn rounded(x: f64, decimals: usize) -> String {
    if x.abs() < 1e9 {
        format!("{x:.decimals$}")
    } else {
        format!("{x:.1e}")
    }
}
