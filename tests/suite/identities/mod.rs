//! Identities of mechanics that tie the generated functions to one another, at seeded states.
//!
//! Derivatives are exact: the functions run on the dual numbers of `num-dual`.

mod any_robot;
mod axes;
mod composed;
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
mod moving;
mod non_finite;
mod place;
mod rates;
mod regressor;
mod samples;
mod single_precision;
mod springs;

use any_robot::Generated;
use robot_dynamics::check::Check;
use robots::*;

/// One test for each identity, on one robot.
macro_rules! identities {
    ($robot:expr; $($module:ident: $($identity:ident),*;)*) => {$($(
        #[test]
        fn $identity() {
            $module::$identity($robot);
        }
    )*)*};
}

/// The identities of all robots, on a base that stands or on one that moves.
macro_rules! identities_of_all {
    ($robot:expr) => {
        identities! { $robot;
            inertia: mass_matrix_is_symmetric,
                mass_matrix_is_positive_definite,
                columns_of_the_mass_matrix_are_torques_of_unit_accelerations;
            coriolis: coriolis_matrix_gives_the_coriolis_vector,
                rate_of_the_mass_matrix_minus_twice_coriolis_is_skew,
                coriolis_vector_is_even_in_the_velocity,
                coriolis_vector_is_quadratic_in_the_velocity;
            energy: kinetic_energy_is_that_of_the_mass_matrix,
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
            kinematics: rotations_are_orthonormal,
                jacobian_is_the_derivative_of_the_pose;
            derivatives: force_derivatives_are_those_of_dual_numbers,
                force_derivatives_are_limits_of_differences,
                acceleration_derivatives_are_those_of_dual_numbers,
                acceleration_derivatives_satisfy_their_equations;
            regressor: base_parameters_give_the_torque_without_springs_and_friction;
            non_finite: forward_dynamics_does_not_hide_a_torque_that_is_not_a_number,
                speeds_to_overflow_give_no_finite_forces;
            single_precision: single_precision_agrees_with_double_precision;
        }
    };
}

/// The identities of robots that have every function.
macro_rules! composed_identities {
    ($robot:expr) => {
        identities! { $robot;
            composed: the_passivity_torque_is_that_of_references,
                the_kinetic_energy_is_that_of_the_parameters,
                the_tip_moves_by_its_jacobian,
                the_tip_is_pushed_by_its_jacobian;
        }
    };
}

/// All identities of links one behind the other on a base that stands.
macro_rules! identities_of_arms {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {$(
        mod $file {
            use super::*;

            identities_of_all!(&Generated::<_, $n, $p>($robot));

            identities! { &Generated::<_, $n, $p>($robot);
                inertia: mass_matrix_is_that_of_the_moving_links;
                coriolis: coriolis_matrix_is_made_of_christoffel_symbols,
                    coriolis_coefficients_are_those_of_the_configuration_space_form;
                energy: potential_energy_is_that_of_weights_and_springs;
                kinematics: link_poses_are_products_of_the_transforms_of_the_table,
                    last_link_pose_is_the_forward_kinematics;
                regressor: columns_of_the_regressor_are_independent,
                    torques_of_any_inertia_are_combinations_of_the_columns;
                non_finite: not_a_number_is_never_turned_into_a_number,
                    infinite_positions_are_never_turned_into_numbers;
            }

            /// At the special states and at some random ones: what is wrong is wrong at most of them. The check of the
            /// PUMA 560 in `tests/systems` is the one that users call, at all its states.
            #[test]
            fn every_function_agrees_with_recursive_newton_euler() {
                Check::new().samples(8).run(&$robot).assert_ok();
            }
        }
    )*};
}
for_each_robot!(identities_of_arms);
identities_of_arms! { tilting_cell: TiltingCell, 4, 6; }
identities_of_arms! { generic_mixed_n6_modified: GenericMixed6Modified, 6, 15; }
identities_of_arms! { sprung_arm: SprungArm, 3, 3; }
identities_of_arms! { sticky_arm: StickyArm, 2, 1; }
identities_of_arms! { gripper_arm: GripperArm, 3, 3; }
identities_of_arms! { palletiser: Palletiser, 3, 3; }

mod composed_of {
    macro_rules! composed_identities_of_arms {
        ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {$(
            mod $file {
                use super::super::*;

                composed_identities!(&Generated::<_, $n, $p>($robot));
            }
        )*};
    }
    robots::for_each_robot!(composed_identities_of_arms);
}

/// All identities of robots that are read at run time.
macro_rules! identities_on_moving_bases {
    ($($file:ident: $robot:ident;)*) => {$(
        mod $file {
            use super::*;

            identities_of_all!(&*moving::$robot);
            composed_identities!(&*moving::$robot);

            identities! { &moving::$robot;
                rates: rates_are_those_along_the_motion,
                    the_center_of_mass_moves_by_its_jacobian,
                    second_derivatives_are_those_of_displacements;
            }

            #[test]
            fn every_function_agrees_with_recursive_newton_euler() {
                Check::new().samples(8).run_any(&moving::$robot.robot).assert_ok();
            }
        }
    )*};
}
identities_on_moving_bases! {
    flyer: FLYER;
    moving_tree: MOVING_TREE;
    body: BODY;
    moving_arm: MOVING_ARM;
    locked_arm: LOCKED_ARM;
}
