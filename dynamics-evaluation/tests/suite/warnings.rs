//! Notes for the reader of a file.

use std::path::Path;

use dynamics_evaluation::{ReadOptions, RuntimeRobot};

fn warnings(file: &str, options: ReadOptions) -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../tests/data")
        .join(file);
    let options = options.entries("gravity = [0, 0, -9.81]");
    let robot = RuntimeRobot::from_file(path, &options).expect("a robot");
    assert_eq!(robot.clone().warnings(), robot.warnings());
    robot.warnings().to_vec()
}

#[test]
fn a_robot_at_run_time_has_them() {
    let with = |function: &str| ReadOptions::new().functions([function]);
    let told = warnings("urdf/ur5_robot.urdf", with("gravity_vector"));
    assert!(
        told.len() == 1 && told[0].starts_with("5 angles, such as 1.57079632679, are taken"),
        "{told:?}"
    );
    let told = warnings("files/nearly_right_angles.urdf", with("base_parameters"));
    assert!(
        told.len() == 1 && told[0].starts_with("Torques hardly tell 2 of the 24 base parameters"),
        "{told:?}"
    );
    let told = warnings("urdf/panda.urdf", with("gravity_vector"));
    assert_eq!(told, [""; 0]);
}
