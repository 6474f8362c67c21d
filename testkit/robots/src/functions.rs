//! The functions of the engine's table with their arguments, as tokens: written by its test `functions`.

/// Hands every function to the macro `$then`, behind a context in braces: `name [argument, ...]`.
#[macro_export]
macro_rules! each_function {
    ($then:path { $($context:tt)* }) => {
        $crate::__functions_of_long_arms! {
            $then { $($context)* }
            inverse_dynamics_second_derivatives [q, qd, qdd]
        }
    };
}

/// As `each_function`, without those that have as many values as the cube of the number of joints.
#[macro_export]
macro_rules! each_function_of_long_arms {
    ($then:path { $($context:tt)* }) => {
        $crate::__functions_of_long_arms! { $then { $($context)* } }
    };
}

/// And some more functions.
#[doc(hidden)]
#[macro_export]
macro_rules! __functions_of_long_arms {
    ($then:path { $($context:tt)* } $($more:tt)*) => {
        $then! {
            { $($context)* }
            mass_matrix [q]
            coriolis_vector [q, qd]
            gravity_vector [q]
            friction_vector [qd]
            spring_vector [q]
            inverse_dynamics [q, qd, qdd]
            forward_dynamics [q, qd, tau]
            kinetic_energy [q, qd]
            potential_energy [q]
            bias_force [q, qd]
            coriolis_matrix [q, qd]
            coriolis_coefficients [q]
            centrifugal_coefficients [q]
            forward_kinematics [q]
            link_poses [q]
            jacobian [q]
            inverse_dynamics_derivatives [q, qd, qdd]
            forward_dynamics_derivatives [q, qd, tau]
            regressor [q, qd, qdd]
            base_parameters []
            forward_dynamics_aba [q, qd, tau]
            taylor_series [q, qd, tau, order]
            wrench_torques [q, wrench]
            tool_velocity [q, qd]
            tool_acceleration [q, qd, qdd]
            jacobian_rate [q, qd]
            link_jacobians [q]
            center_of_mass [q]
            center_of_mass_jacobian [q]
            centroidal_momentum_matrix [q]
            centroidal_momentum_bias [q, qd]
            operational_inertia_inverse [q]
            generalized_momentum [q, qd]
            momentum_bias [q, qd]
            passivity_torque [q, qd, qd_r, qdd_r]
            passivity_regressor [q, qd, qd_r, qdd_r]
            energy_regressors [q, qd]
            inverse_dynamics_rates [q, qd, qdd, jerk, snap]
            $($more)*
        }
    };
}

/// Every function with its batches: `name name_batch par_name_batch [argument, ...]`.
#[macro_export]
macro_rules! each_batch {
    ($then:path { $($context:tt)* }) => {
        $then! {
            { $($context)* }
            mass_matrix mass_matrix_batch par_mass_matrix_batch [q]
            coriolis_vector coriolis_vector_batch par_coriolis_vector_batch [q, qd]
            gravity_vector gravity_vector_batch par_gravity_vector_batch [q]
            friction_vector friction_vector_batch par_friction_vector_batch [qd]
            spring_vector spring_vector_batch par_spring_vector_batch [q]
            inverse_dynamics inverse_dynamics_batch par_inverse_dynamics_batch [q, qd, qdd]
            forward_dynamics forward_dynamics_batch par_forward_dynamics_batch [q, qd, tau]
            kinetic_energy kinetic_energy_batch par_kinetic_energy_batch [q, qd]
            potential_energy potential_energy_batch par_potential_energy_batch [q]
            bias_force bias_force_batch par_bias_force_batch [q, qd]
            coriolis_matrix coriolis_matrix_batch par_coriolis_matrix_batch [q, qd]
            coriolis_coefficients coriolis_coefficients_batch par_coriolis_coefficients_batch [q]
            centrifugal_coefficients centrifugal_coefficients_batch par_centrifugal_coefficients_batch [q]
            forward_kinematics forward_kinematics_batch par_forward_kinematics_batch [q]
            link_poses link_poses_batch par_link_poses_batch [q]
            jacobian jacobian_batch par_jacobian_batch [q]
            inverse_dynamics_derivatives inverse_dynamics_derivatives_batch par_inverse_dynamics_derivatives_batch [q, qd, qdd]
            forward_dynamics_derivatives forward_dynamics_derivatives_batch par_forward_dynamics_derivatives_batch [q, qd, tau]
            regressor regressor_batch par_regressor_batch [q, qd, qdd]
            base_parameters base_parameters_batch par_base_parameters_batch []
            forward_dynamics_aba forward_dynamics_aba_batch par_forward_dynamics_aba_batch [q, qd, tau]
            taylor_series taylor_series_batch par_taylor_series_batch [q, qd, tau, order]
            wrench_torques wrench_torques_batch par_wrench_torques_batch [q, wrench]
            tool_velocity tool_velocity_batch par_tool_velocity_batch [q, qd]
            tool_acceleration tool_acceleration_batch par_tool_acceleration_batch [q, qd, qdd]
            jacobian_rate jacobian_rate_batch par_jacobian_rate_batch [q, qd]
            link_jacobians link_jacobians_batch par_link_jacobians_batch [q]
            center_of_mass center_of_mass_batch par_center_of_mass_batch [q]
            center_of_mass_jacobian center_of_mass_jacobian_batch par_center_of_mass_jacobian_batch [q]
            centroidal_momentum_matrix centroidal_momentum_matrix_batch par_centroidal_momentum_matrix_batch [q]
            centroidal_momentum_bias centroidal_momentum_bias_batch par_centroidal_momentum_bias_batch [q, qd]
            operational_inertia_inverse operational_inertia_inverse_batch par_operational_inertia_inverse_batch [q]
            generalized_momentum generalized_momentum_batch par_generalized_momentum_batch [q, qd]
            momentum_bias momentum_bias_batch par_momentum_bias_batch [q, qd]
            passivity_torque passivity_torque_batch par_passivity_torque_batch [q, qd, qd_r, qdd_r]
            passivity_regressor passivity_regressor_batch par_passivity_regressor_batch [q, qd, qd_r, qdd_r]
            energy_regressors energy_regressors_batch par_energy_regressors_batch [q, qd]
            inverse_dynamics_rates inverse_dynamics_rates_batch par_inverse_dynamics_rates_batch [q, qd, qdd, jerk, snap]
            inverse_dynamics_second_derivatives inverse_dynamics_second_derivatives_batch par_inverse_dynamics_second_derivatives_batch [q, qd, qdd]
        }
    };
}
