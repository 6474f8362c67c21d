//! Inverse kinematics in closed form: the time of all solutions of a pose, and how far they are from it, as a table for
//! `benches/inverse.sh`.
//!
//! `taskset -c 0 cargo bench -p benches --bench closed_forms`. Poses are those of random positions of the joints. The arms are
//! those of `tests/inverse`, one of each class.

#[path = "../tests/inverse/arms.rs"]
mod arms;

use std::hint::black_box;

use arms::*;
use measuring::table::Table;
use measuring::{median, seconds};
use robot_dynamics::nalgebra::{Matrix4, SVector};
use testkit::random::Random;

const POSES: usize = 1_000;
const RUNS: usize = 31;

/// The name of an arm in the table.
fn name(arm: &'static str) -> &'static str {
    match arm {
        "Puma560" => "PUMA 560, spherical wrist",
        "Ur5" => "UR5, three parallel axes",
        "Stanford" => "Stanford arm",
        "Shoulder" => "spherical shoulder, with base and tool",
        "ThreeRolls" => "wrist of three rolls at 60 degrees",
        "GantryWithWrist" => "gantry with a wrist",
        "SevenJoints" => "seven joints, steps at the elbow, tool",
        "Iiwa14" => "KUKA LBR iiwa 14, one angle of the elbow",
        "Scara" => "SCARA",
        "Elbow3r" => "three joints, position",
        "RrrPlanar" => "plane arm, position and angle",
        "Cylindrical" => "cylindrical arm, position",
        "TwoLink" => "two links, position",
        "EqualHalves" => "seven joints, halves of equal length",
        other => other,
    }
}

/// Seven joints have one more argument.
macro_rules! solutions {
    ($arm:ident, $pose:ident, 7) => {
        $arm.inverse_kinematics($pose, 0.3)
    };
    ($arm:ident, $pose:ident, $n:tt) => {
        $arm.inverse_kinematics($pose)
    };
}

macro_rules! rows {
    ($($name:ident: $n:tt, $reads_rotation:literal;)*) => {{
        let mut table = Table::new("", &["arm", "joints", "solutions", "ns for all", "error"]);
        $({
            let arm = $name;
            let mut random = Random::seeded(1);
            let joints = (0..POSES).map(|_| SVector::<f64, $n>::from_fn(|_, _| random.between(-3.1, 3.1)));
            let poses: Vec<Matrix4<f64>> = joints.map(|q| arm.forward_kinematics(&q)).collect();
            let (mut count, mut error) = (0, 0.0_f64);
            for pose in &poses {
                let solutions = solutions!(arm, pose, $n);
                count += solutions.len();
                for solution in &solutions {
                    let miss = (arm.forward_kinematics(&solution.q) - pose).abs();
                    let first = if $reads_rotation { 0 } else { 3 };
                    error = error.max(miss.columns(first, 4 - first).max());
                }
            }
            let solve_all = || {
                for pose in &poses {
                    let pose = black_box(pose);
                    black_box(solutions!(arm, pose, $n));
                }
            };
            let times = (0..RUNS).map(|_| 1e9 * seconds(solve_all).1 / POSES as f64);
            let time = median(times);
            table.row([
                name(stringify!($name)).to_owned(),
                $n.to_string(),
                format!("{:.1}", count as f64 / POSES as f64),
                format!("{time:.0}"),
                format!("{error:.0e}"),
            ]);
        })*
        print!("{}", table.markdown_rows());
    }};
}

fn main() {
    for_each_arm!(rows);
}
