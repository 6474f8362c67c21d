//! Identities of mechanics that tie the generated functions to one another, at seeded states.
//!
//! Derivatives are exact: the functions run on the dual numbers of `num-dual`.

mod any_arm;
mod axes;
mod coriolis;
mod derivatives;
mod energy;
mod forward;
mod friction;
mod gradient;
mod inertia;
mod inverse;
mod kinematics;
mod momenta;
mod newton_euler;
mod non_finite;
mod regressor;
mod samples;
mod single_precision;
mod springs;

use robots::*;

/// One test for each identity, on one robot.
macro_rules! identities {
    ($robot:ident, $n:literal, $p:literal: $($module:ident: $($identity:ident),*;)*) => {$($(
        #[test]
        fn $identity() {
            $module::$identity::<$n, $p>(&$robot);
        }
    )*)*};
}

macro_rules! identities_of_all {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {$(
        mod $file {
            use super::*;

            identities! { $robot, $n, $p:
                inertia: mass_matrix_is_symmetric,
                    mass_matrix_is_positive_definite,
                    mass_matrix_is_that_of_the_moving_links,
                    columns_of_the_mass_matrix_are_torques_of_unit_accelerations;
                coriolis: coriolis_matrix_gives_the_coriolis_vector,
                    coriolis_matrix_is_made_of_christoffel_symbols,
                    rate_of_the_mass_matrix_minus_twice_coriolis_is_skew,
                    coriolis_coefficients_are_those_of_the_configuration_space_form,
                    coriolis_vector_is_even_in_the_velocity,
                    coriolis_vector_is_quadratic_in_the_velocity;
                energy: kinetic_energy_is_that_of_the_mass_matrix,
                    potential_energy_is_that_of_weights_and_springs,
                    gravity_and_springs_are_the_gradient_of_the_potential_energy,
                    power_of_the_torques_is_the_rate_of_the_energy;
                inverse: inverse_dynamics_is_the_sum_of_its_terms,
                    bias_force_is_the_torque_without_acceleration;
                forward: forward_dynamics_undoes_inverse_dynamics,
                    inverse_dynamics_undoes_forward_dynamics;
                momenta: forces_on_momenta_are_those_of_the_coriolis_matrix,
                    velocity_undoes_momentum;
                springs: springs_are_those_of_the_table,
                    nothing_pulls_at_rest;
                friction: friction_is_that_of_the_table,
                    nothing_rubs_at_rest;
                kinematics: link_poses_are_products_of_the_transforms_of_the_table,
                    last_link_pose_is_the_forward_kinematics,
                    rotations_are_orthonormal,
                    jacobian_is_the_derivative_of_the_pose;
                derivatives: force_derivatives_are_those_of_dual_numbers,
                    force_derivatives_are_limits_of_differences,
                    acceleration_derivatives_are_those_of_dual_numbers,
                    acceleration_derivatives_satisfy_their_equations;
                regressor: base_parameters_give_the_torque_without_springs_and_friction,
                    columns_of_the_regressor_are_independent,
                    torques_of_any_inertia_are_combinations_of_the_columns;
                non_finite: not_a_number_is_never_turned_into_a_number,
                    infinite_positions_are_never_turned_into_numbers,
                    forward_dynamics_does_not_hide_a_torque_that_is_not_a_number,
                    speeds_to_overflow_give_no_finite_forces;
                single_precision: single_precision_agrees_with_double_precision;
            }

            #[test]
            fn every_function_agrees_with_recursive_newton_euler() {
                newton_euler::every_function_agrees_with_recursive_newton_euler(&$robot);
            }
        }
    )*};
}
for_each_robot!(identities_of_all);
identities_of_all! { tilting_cell: TiltingCell, 4, 6; }
identities_of_all! { generic_mixed_n6_modified: GenericMixed6Modified, 6, 15; }
identities_of_all! { sprung_arm: SprungArm, 3, 3; }
identities_of_all! { sticky_arm: StickyArm, 2, 1; }
identities_of_all! { gripper_arm: GripperArm, 3, 3; }
identities_of_all! { palletiser: Palletiser, 3, 3; }
