//! The cost of a function does not depend on how many others are in the crate: its sines are evaluated by the same
//! instructions.

use std::hint::black_box;

use robot_dynamics::nalgebra::Vector3;

use crate::machine_code::Listing;
use crate::three_joints::{ThreeJoints, gravity_at_three_angles};

macro_rules! each_in_both_precisions {
    ([$q:ident, $qd:ident, $qdd:ident] $($function:ident($($argument:ident),*);)*) => {
        /// Calls of all of them; their number.
        fn others() -> usize {
            let mut count = 0;
            $({
                #[inline(never)]
                fn double([$q, $qd, $qdd]: &[Vector3<f64>; 3]) {
                    let _ = ($q, $qd, $qdd);
                    let _ = black_box(ThreeJoints.$function($($argument),*));
                }
                #[inline(never)]
                fn single([$q, $qd, $qdd]: &[Vector3<f32>; 3]) {
                    let _ = ($q, $qd, $qdd);
                    let _ = black_box(ThreeJoints.$function($($argument),*));
                }
                double(&black_box([Vector3::repeat(0.1); 3]));
                single(&black_box([Vector3::repeat(0.1); 3]));
                count += 2;
            })*
            count
        }
    };
}

each_in_both_precisions! {
    [q, qd, qdd]
    mass_matrix(q);
    coriolis_vector(q, qd);
    gravity_vector(q);
    inverse_dynamics(q, qd, qdd);
    forward_dynamics(q, qd, qdd);
    kinetic_energy(q, qd);
    potential_energy(q);
    bias_force(q, qd);
    coriolis_matrix(q, qd);
    coriolis_coefficients(q);
    centrifugal_coefficients(q);
    forward_kinematics(q);
    link_poses(q);
    jacobian(q);
    jacobian_rate(q, qd);
    tool_velocity(q, qd);
    tool_acceleration(q, qd, qdd);
    link_jacobians(q);
    center_of_mass(q);
    center_of_mass_jacobian(q);
    generalized_momentum(q, qd);
    momentum_bias(q, qd);
    inverse_dynamics_derivatives(q, qd, qdd);
    regressor(q, qd, qdd);
}

/// The names of the instructions of a function and of the method that it calls: which registers they read differs.
fn instructions(listing: &Listing) -> Vec<String> {
    let reached = listing.reached_from("gravity_at_three_angles");
    let own = ["gravity_at_three_angles", "gravity_vector"].map(|name| {
        let of_name = reached.iter().find(|(found, _)| found.contains(name));
        of_name.expect("the function is in the listing").1
    });
    let word = |line: &String| {
        line.split_whitespace()
            .next()
            .unwrap_or_default()
            .to_owned()
    };
    // Instructions that fill the space up to the next function are not executed.
    let filling = |word: &String| word.starts_with("nop") || word == "int3" || word == "xchg";
    own.into_iter()
        .flatten()
        .map(word)
        .filter(|word| !filling(word))
        .collect()
}

#[test]
fn a_function_among_forty_is_that_of_a_crate_by_itself() {
    assert!(others() >= 40);
    black_box(gravity_at_three_angles(&black_box(Vector3::repeat(0.2))));
    let Some(many) = Listing::of_program(&std::env::current_exe().expect("a program")) else {
        return;
    };
    let Some(alone) = Listing::of_program(env!("CARGO_BIN_EXE_alone").as_ref()) else {
        return;
    };
    let [among_many, alone] = [&many, &alone].map(instructions);
    println!(
        "{} instructions among many, {} alone",
        among_many.len(),
        alone.len()
    );
    assert_eq!(among_many, alone);
    // All that takes angles in an array is a part of its caller.
    for name in ["sin_cos_array", "of_array"] {
        let left: Vec<_> = many
            .reached_from(name)
            .into_iter()
            .map(|(name, _)| name)
            .collect();
        assert!(left.is_empty(), "{left:?}");
    }
}
