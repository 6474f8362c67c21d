//! From a URDF file to torques: an arm of four joints with a gripper, what a motion asks of its motors, and
//! where a motor would be too weak.
//!
//! ```text
//! cargo run --release --example urdf
//! ```

use robot_dynamics::nalgebra::Vector4;
use robot_dynamics::{Cycloidal, check_against_rnea, robot_dynamics};

robot_dynamics! {
    /// The arm of the file, with its finger half open and a `load` at its tool.
    struct Picker { load: f64 }

    file: "examples/robots/picker.urdf",
    chain: ["base_link", "tool0"],
    // A movable joint beside the chain: it stands still.
    lock: [finger = 0.02],
    // The file has 1.5708 where a quarter turn is meant.
    round_angles: 1e-4,
    gravity: [0, 0, -9.81],
    tool: { mass: load },
    functions: [default, forward_kinematics],
}

/// The greatest torques of the motors, N m: the `effort` of the file.
fn greatest_torques() -> Vector4<f64> {
    Picker::TORQUE_LIMITS
        .map(|limit| limit.unwrap_or(f64::INFINITY))
        .into()
}

/// The motion: the load is lifted and turned aside.
const START: Vector4<f64> = Vector4::new(0.0, 0.3, -1.2, 0.0);
const END: Vector4<f64> = Vector4::new(1.5, 1.2, -0.6, 1.0);

/// The largest torque of each motor in a motion of some duration.
fn largest_torques(arm: &Picker, duration: f64) -> Vector4<f64> {
    let motion = Cycloidal::new(START, END, duration).expect("the duration is positive");
    let torques = motion
        .samples(101)
        .map(|(_, at)| arm.inverse_dynamics(&at.q, &at.qd, &at.qdd).abs());
    torques.fold(Vector4::zeros(), |largest, tau| largest.sup(&tau))
}

fn main() {
    let arm = Picker { load: 1.0 };
    println!("{}", check_against_rnea(&arm));

    let tip = arm.forward_kinematics(&END);
    println!(
        "the tip ends at {:.3}, {:.3}, {:.3} m",
        tip[(0, 3)],
        tip[(1, 3)],
        tip[(2, 3)]
    );

    println!("largest torques, N m, with a load of 1 kg:");
    println!("duration, s  {}", Picker::JOINT_NAMES.join("  "));
    for duration in [2.0, 1.0, 0.5, 0.25] {
        let torques = largest_torques(&arm, duration);
        let share = torques.component_div(&greatest_torques()).max();
        let verdict = if share > 1.0 { "too fast" } else { "" };
        println!("{duration:11}  {:6.2?}  {verdict}", torques.as_slice());
    }

    // Slowly, the motors hold the weight; fast, they feel the masses.
    let (slow, fast) = (largest_torques(&arm, 100.0), largest_torques(&arm, 0.25));
    let held = arm.gravity_vector(&START);
    assert!(slow[1] >= held[1].abs() && slow[1] < greatest_torques()[1]);
    assert!(fast[0] > 10.0 * slow[0]);
}
