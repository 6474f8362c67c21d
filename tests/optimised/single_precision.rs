//! Functions at `f32` have no operation in double precision, but for one conversion of each field that they read: their
//! machine code is looked at.

use std::hint::black_box;
use std::path::Path;
use std::process::Command;

use crate::machine_code::{Listing, is_of_doubles, is_of_doubles_on_arm};
use robot_dynamics::nalgebra::{Vector1, Vector3, Vector6};
use robot_dynamics::{Batch as _, SingularMassMatrix, robot_dynamics};

robot_dynamics! {
    /// An elbow arm with everything that adds operations of another kind.
    pub struct Arm;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.5, alpha: PI/2, mass: 9, com: [0, -0.1, 0], inertia: cylinder(0.1, 0.5),
            friction: { viscous: 0.3, coulomb: 1.5, stribeck: { static: 2, velocity: 0.01 } },
        },
        shoulder: revolute { a: 0.4, mass: 5, com: [-0.2, 0, 0.02], inertia: rod(0.4) },
        elbow: revolute { a: 0.3, mass: 2, com: [-0.1, 0, 0], inertia: rod(0.3) },
    ],
    functions: [default, inverse_dynamics_derivatives],
}

robot_dynamics! {
    /// A mass beside 1 + 2^-24, the middle between two singles: rounded to a double it is the middle.
    pub struct Middle;

    convention: modified,
    gravity: [0, -1, 0],
    joints: [link: revolute { mass: 1.000000059604644775390625000001, com: [1, 0, 0] }],
    functions: [gravity_vector],
}

type Vector = Vector3<f32>;

#[inline(never)]
fn torques_in_singles(q: &Vector, qd: &Vector, qdd: &Vector) -> Vector {
    Arm.inverse_dynamics(q, qd, qdd)
}

#[inline(never)]
fn derivatives_in_singles(q: &Vector, qd: &Vector, qdd: &Vector) -> Vector6<f32> {
    let (by_position, by_velocity) = Arm.inverse_dynamics_derivatives(q, qd, qdd);
    let (a, b) = (by_position.column(1), by_velocity.column(2));
    Vector6::new(a[0], a[1], a[2], b[0], b[1], b[2])
}

#[inline(never)]
fn accelerations_in_singles(
    q: &Vector,
    qd: &Vector,
    tau: &Vector,
) -> Result<Vector, SingularMassMatrix> {
    Arm.forward_dynamics(q, qd, tau)
}

/// In doubles: what the test must find.
#[inline(never)]
fn torques_in_doubles(q: &Vector3<f64>) -> Vector3<f64> {
    Arm.gravity_vector(q)
}

#[test]
fn functions_of_singles_have_no_operation_in_double() {
    let [q, qd, x] = [1.0, 2.0, 3.0].map(|x| black_box(Vector::new(x, 0.5, -x)));
    black_box(torques_in_singles(&q, &qd, &x));
    black_box(derivatives_in_singles(&q, &qd, &x));
    black_box(accelerations_in_singles(&q, &qd, &x)).expect("M is regular");
    black_box(torques_in_doubles(&black_box(Vector3::new(0.1, 0.2, 0.3))));
    let program = std::env::current_exe().expect("a program");
    let Some(listing) = Listing::of_program(&program) else {
        return;
    };
    for function in [
        "torques_in_singles",
        "derivatives_in_singles",
        "accelerations_in_singles",
    ] {
        listing.assert_free(function, is_of_doubles);
    }
    let reached = listing.reached_from("torques_in_doubles");
    let mut all = reached.iter().flat_map(|(_, instructions)| *instructions);
    assert!(all.any(|line| is_of_doubles(line)));
}

#[test]
fn constants_are_rounded_once() {
    let nearest = 1.0_f32.next_up();
    let torque = Middle.gravity_vector(&Vector1::new(0.0_f32));
    assert_eq!(torque[0], nearest);
    assert_eq!(
        Middle.gravity_vector(&Vector1::new(0.0_f64))[0],
        1.0 + 0.5_f64.powi(24)
    );
    let mut torques = [Vector1::zeros(); 20];
    Middle
        .gravity_vector_batch(&[Vector1::new(0.0_f32); 20], &mut torques)
        .expect("as many torques");
    assert_eq!(torques, [Vector1::new(nearest); 20]);
}

/// The program without the standard library, for a processor without doubles. The field of its arm, an `f64`, is
/// converted by one call each time that a method reads it; nothing else is of doubles.
#[test]
fn a_cortex_m4f_computes_torques_without_doubles() {
    const TARGET: &str = "thumbv7em-none-eabihf";
    let installed = Command::new("rustup")
        .args(["target", "list", "--installed"])
        .output();
    let installed =
        installed.map(|output| String::from_utf8_lossy(&output.stdout).contains(TARGET));
    if !installed.unwrap_or(false) {
        assert!(
            std::env::var_os("CI").is_none(),
            "the target {TARGET} is not installed"
        );
        return println!("left out: the target {TARGET} is not installed");
    }
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../no_std");
    let built = Command::new(env!("CARGO"))
        .args([
            "rustc",
            "--quiet",
            "--release",
            "--target",
            TARGET,
            "--crate-type",
            "rlib",
        ])
        .args([
            "--target-dir",
            "target/optimised",
            "--",
            "--emit",
            "asm",
            "-C",
            "codegen-units=1",
        ])
        .current_dir(&program)
        .status();
    assert!(built.is_ok_and(|status| status.success()));
    let folder = program
        .join("target/optimised")
        .join(TARGET)
        .join("release/deps");
    let files = std::fs::read_dir(folder)
        .expect("a folder")
        .flatten()
        .map(|file| file.path());
    let written = |file: &std::path::PathBuf| file.metadata().and_then(|data| data.modified()).ok();
    let latest = files
        .filter(|file| file.extension().is_some_and(|end| end == "s"))
        .max_by_key(written);
    let text = std::fs::read_to_string(latest.expect("assembly")).expect("a text");
    let listing = Listing::of_assembly(&text);
    let found = listing.of_kind("computed_torque", is_of_doubles_on_arm);
    assert_eq!(found, ["call <__aeabi_d2f>"]);
}
