//! Programs that no linker accepts if anything in them can panic: their panic handler calls a function that is nowhere.
//! `no_std/tests/panics.rs` links them, for this machine and for a Cortex-M4F, in each precision.
#![no_std]

use core::hint::black_box;
use core::panic::PanicInfo;

use robot_dynamics::closed_form::Solutions;
use robot_dynamics::nalgebra::{Matrix4, Vector3};
use robot_dynamics::robot_dynamics;

// The C library of a machine starts a program, and copies.
#[cfg_attr(not(target_os = "none"), link(name = "c"))]
unsafe extern "C" {
    safe fn something_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    something_can_panic()
}

/// The core library asks a machine for it, though nothing unwinds.
#[cfg(not(target_os = "none"))]
#[unsafe(no_mangle)]
pub extern "C" fn rust_eh_personality() {}

robot_dynamics! {
    /// An elbow arm with motors and friction.
    pub struct Elbow;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.5, alpha: PI/2, mass: 9, com: [0, -0.1, 0], inertia: cylinder(0.1, 0.5),
            motor: { inertia: 1e-4, gear_ratio: 50 }, friction: { viscous: 0.3, coulomb: 1.5 },
        },
        shoulder: revolute { a: 0.4, mass: 5, com: [-0.2, 0, 0.02], inertia: rod(0.4) },
        elbow: revolute { a: 0.3, mass: 2, com: [-0.1, 0, 0], inertia: rod(0.3) },
    ],
    functions: [default, forward_kinematics, jacobian, inverse_kinematics],
}

/// The functions in one precision, each at a state of which the compiler knows nothing.
macro_rules! functions_of {
    ($number:ident) => {{
        let state = || black_box(Vector3::<$number>::zeros());
        let [q, qd, x] = [state(), state(), state()];
        black_box(Elbow.mass_matrix(&q));
        black_box(Elbow.coriolis_vector(&q, &qd));
        black_box(Elbow.gravity_vector(&q));
        black_box(Elbow.inverse_dynamics(&q, &qd, &x));
        black_box(Elbow.friction_vector(&qd));
        black_box(Elbow.kinetic_energy(&q, &qd));
        black_box(Elbow.potential_energy(&q));
        black_box(Elbow.forward_kinematics(&q));
        black_box(Elbow.jacobian(&q));
        let _ = black_box(Elbow.forward_dynamics(&q, &qd, &x));
        black_box(Elbow.inverse_kinematics(&black_box(Matrix4::<$number>::identity())));
    }};
}

/// In single precision.
pub fn singles() {
    functions_of!(f32);
}

/// In double precision.
pub fn doubles() {
    functions_of!(f64);
}

/// The choice among solutions, whose limits are doubles.
pub fn choices() {
    macro_rules! choice_in {
        ($number:ident) => {
            let solutions = black_box(Solutions::<$number, 3>::default());
            let within = solutions.within(&black_box(Elbow::JOINT_LIMITS));
            black_box(within.nearest(&black_box(Vector3::zeros())));
            black_box(within.len());
        };
    }
    choice_in!(f32);
    choice_in!(f64);
}
