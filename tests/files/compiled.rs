//! URDF through the macro: what is compiled is what the table says.

use robot_dynamics::nalgebra::{SVector, Vector3};
use robot_dynamics::{NewtonEuler, check_against_rnea, robot_dynamics};

robot_dynamics! {
    /// Franka's arm with its hand, the fingers where they hold something.
    struct Panda;
    file: "../data/urdf/panda.urdf", chain: ["panda_link0", "panda_hand_tcp"],
    gravity: [0, 0, -9.81],
    lock: [panda_finger_joint1 = 0.02, panda_finger_joint2 = 0.035],
    functions: [inverse_dynamics, mass_matrix, forward_kinematics, link_poses],
}

robot_dynamics! {
    /// An arm whose axes are x, y and z, with a tool of its user's and a joint that stands still.
    struct Ur5 { load: f64 }
    file: "../data/urdf/ur5_robot.urdf",
    chain: ["base_link", "tool0"],
    gravity: [0, 0, -9.81],
    lock: [wrist_1_joint = deg(-30)],
    tool: { xyz: [0, 0, 0.1], rpy: [0, 0.3, 0], mass: load, com: [0, 0, 0.02] },
    functions: [default, jacobian, forward_kinematics],
}

robot_dynamics! {
    /// A leg whose axes are slanted.
    struct Leg;
    file: "../data/urdf/finger_edu.urdf", chain: ["base_link", "finger_tip_link"],
    gravity: [0, 0, -9.81],
    round_angles: 1e-4,
}

#[test]
fn generated_functions_agree_with_newton_euler_on_the_table() {
    check_against_rnea(&Panda).assert_ok();
    check_against_rnea(&Ur5 { load: 2.5 }).assert_ok();
    check_against_rnea(&Leg).assert_ok();
}

/// The tip and the link frames are those of the file, as the numeric algorithms have them from the table.
#[test]
fn frames_are_those_of_the_file() {
    let ur5 = Ur5 { load: 2.5 };
    let q = SVector::from([0.3, -1.2, 0.8, -0.4, 1.9]);
    let numeric = NewtonEuler::new(&ur5.table());
    let difference = ur5.forward_kinematics(&q) - numeric.forward_kinematics(&q);
    assert!(difference.amax() < 1e-14, "{difference}");
    let q = SVector::from([0.3, -1.2, 0.8, -1.4, 1.9, 0.7, -0.5]);
    let poses = NewtonEuler::new(&Panda.table()).link_poses(&q);
    for (pose, expected) in Panda.link_poses(&q).iter().zip(&poses) {
        assert!((pose - expected).amax() < 1e-14);
    }
    // At rest the second axis is along -y of the base: the file turns it by roll, the table by alpha.
    let pose = Panda.link_poses(&SVector::zeros())[1];
    let axis: Vector3<f64> = pose.fixed_view::<3, 1>(0, 2).into_owned();
    assert!(
        (axis - Vector3::new(0.0, 1.0, 0.0)).amax() < 1e-15,
        "{axis}"
    );
}
