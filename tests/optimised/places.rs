//! A program that calls eleven methods of an arm at one place, or at many: a test measures how long it takes to
//! compile.
#![allow(
    unexpected_cfgs,
    reason = "the test compiles the program with these settings, and no other build has them"
)]

use std::hint::black_box;

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::robot_dynamics;

robot_dynamics! {
    struct Ur10;

    file: "../data/urdf/ur10_robot.urdf", chain: ["base_link", "ee_link"],
    gravity: [0, 0, -9.81],
    functions: [default, bias_force, coriolis_matrix, forward_kinematics, jacobian],
}

macro_rules! at_each_place {
    ($($place:literal)*) => {
        fn main() {
            let states = black_box([[SVector::<f64, 6>::repeat(0.1); 3]; 24]);
            $({
                let [q, qd, x] = &states[$place];
                let _ = black_box((
                    Ur10.mass_matrix(q),
                    Ur10.coriolis_vector(q, qd),
                    Ur10.gravity_vector(q),
                    Ur10.inverse_dynamics(q, qd, x),
                    Ur10.forward_dynamics(q, qd, x),
                    Ur10.kinetic_energy(q, qd),
                    Ur10.potential_energy(q),
                    Ur10.bias_force(q, qd),
                    Ur10.coriolis_matrix(q, qd),
                    Ur10.forward_kinematics(q),
                    Ur10.jacobian(q),
                ));
            })*
        }
    };
}

#[cfg(at_24_places)]
at_each_place!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23);
#[cfg(not(at_24_places))]
at_each_place!(0);
