//! Robots of many joints, followers and frames, as humanoids and hands have them, beside Newton-Euler.

use std::fmt::Write as _;
use std::path::Path;

use dynamics_evaluation::{ReadOptions, RuntimeRobot, read_source};
use dynamics_numeric::check::Check;

/// A URDF file of so many limbs on one link, each with so many joints that move by themselves and so many that follow
/// the first of these. Every joint has another axis and length.
fn limbs(limbs: usize, free: usize, followers: usize) -> String {
    let mut text = "<robot name=\"limbs\"><link name=\"root\"/>".to_owned();
    for limb in 0..limbs {
        for k in 0..free + followers {
            let carrier = match k {
                0 => "root".to_owned(),
                k => format!("l{limb}_{}", k - 1),
            };
            let size = 1.0 + 0.1 * ((limb * 7 + k * 3) % 11) as f64;
            let axis = ["1 0 0", "0 1 0", "0.6 0 0.8"][(limb + k) % 3];
            let mimic = match k < free {
                true => String::new(),
                false => {
                    format!("<mimic joint=\"j{limb}_0\" multiplier=\"{size}\" offset=\"0.1\"/>")
                }
            };
            writeln!(
                text,
                "<link name=\"l{limb}_{k}\"><inertial><origin xyz=\"0.01 {} 0.03\"/><mass value=\"{size}\"/>\
                 <inertia ixx=\"0.02\" iyy=\"0.03\" izz=\"0.025\" ixy=\"0.001\" ixz=\"0\" iyz=\"0\"/></inertial></link>\
                 <joint name=\"j{limb}_{k}\" type=\"revolute\"><parent link=\"{carrier}\"/><child link=\"l{limb}_{k}\"/>\
                 <origin xyz=\"{} 0 0.1\" rpy=\"0.1 0 {}\"/><axis xyz=\"{axis}\"/>{mimic}\
                 <limit lower=\"-1\" upper=\"1\" effort=\"10\" velocity=\"1\"/></joint>",
                0.01 * size,
                0.02 * size,
                0.3 * limb as f64
            )
            .expect("text");
        }
    }
    text + "</robot>"
}

/// The robot of a file with these functions, compared with Newton-Euler.
#[track_caller]
fn checked(file: &str, functions: &[&str]) -> RuntimeRobot {
    let options = ReadOptions::new().entries("gravity = [0, 0, -9.81]");
    let options = match functions {
        [] => options,
        functions => options.functions(functions.iter().copied()),
    };
    let model = read_source(Path::new("limbs.urdf"), file, &options);
    let model = model.unwrap_or_else(|error| panic!("{error}"));
    let requests = model.requests.into_iter().map(|(request, _)| request);
    let robot = RuntimeRobot::new(model.robot, requests).unwrap_or_else(|error| panic!("{error}"));
    let report = Check::new().samples(2).run_any(&robot);
    assert!(report.is_ok(), "{report}");
    robot
}

#[test]
fn many_joints_follow_others() {
    for (count, free, followers) in [(3, 2, 3), (4, 2, 4), (10, 2, 4)] {
        let robot = checked(&limbs(count, free, followers), &[]);
        let table = robot.table();
        assert_eq!(table.followers().count(), count * followers);
        assert_eq!(table.rows.len(), count * free);
    }
}

#[test]
fn seventy_joints() {
    let robot = checked(&limbs(5, 14, 0), &[]);
    assert_eq!(robot.table().rows.len(), 70);
}

/// Each frame has a value of its own in the comparison.
#[test]
fn many_frames() {
    let functions: Vec<_> = (0..20).map(|limb| format!("jacobian(l{limb}_1)")).collect();
    let functions: Vec<&str> = functions.iter().map(String::as_str).collect();
    let robot = checked(&limbs(20, 2, 0), &functions);
    assert_eq!(robot.table().frames.len(), 20);
}

#[test]
fn long_functions_of_a_humanoid() {
    let functions = [
        "coriolis_matrix",
        "inverse_dynamics_derivatives",
        "base_parameters",
        "regressor",
    ];
    let robot = checked(&limbs(2, 19, 0), &functions);
    assert_eq!(robot.dof(), 38);
}
