//! The functions of the engine's table with their arguments, as tokens: written by its test `functions`.

/// Hands every function to the macro `$then`, behind a context in braces: `name [argument, ...]`.
#[macro_export]
macro_rules! each_function {
    ($then:path { $($context:tt)* }) => {
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
            operational_inertia_inverse [q]
            generalized_momentum [q, qd]
            momentum_bias [q, qd]
            passivity_torque [q, qd, qd_r, qdd_r]
            passivity_regressor [q, qd, qd_r, qdd_r]
            energy_regressors [q, qd]
            inverse_dynamics_rates [q, qd, qdd, jerk, snap]
            inverse_dynamics_second_derivatives [q, qd, qdd]
        }
    };
}

/// As `each_function`, without those that have as many values as the cube of the number of joints.
#[macro_export]
macro_rules! each_function_of_long_arms {
    ($then:path { $($context:tt)* }) => {
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
            operational_inertia_inverse [q]
            generalized_momentum [q, qd]
            momentum_bias [q, qd]
            passivity_torque [q, qd, qd_r, qdd_r]
            passivity_regressor [q, qd, qd_r, qdd_r]
            energy_regressors [q, qd]
            inverse_dynamics_rates [q, qd, qdd, jerk, snap]
        }
    };
}
