//! Robots with every function.

/// `robot_dynamics!` for the given table, every function asked for by name.
macro_rules! every_function {
    ($($table:tt)*) => {
        robot_dynamics! {
            $($table)*
            functions: [
                mass_matrix,
                coriolis_vector,
                gravity_vector,
                friction_vector,
                inverse_dynamics,
                forward_dynamics,
                kinetic_energy,
                potential_energy,
                bias_force,
                coriolis_matrix,
                coriolis_coefficients,
                centrifugal_coefficients,
                forward_kinematics,
                link_poses,
                jacobian,
                inverse_dynamics_derivatives,
                forward_dynamics_derivatives,
                regressor,
                base_parameters,
                forward_dynamics_aba,
                taylor_series,
            ],
        }
    };
}
