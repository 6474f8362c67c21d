//! The functions by their names, as a generated struct has them.

use dynamics_runtime::nalgebra::{DMatrix, DVector};

use crate::{EvaluationError, RuntimeRobot};

/// What [`RuntimeRobot::inverse_dynamics_derivatives`] returns.
type TorqueDerivatives = (DMatrix<f64>, DMatrix<f64>);

/// What [`RuntimeRobot::forward_dynamics_derivatives`] returns.
type AccelerationDerivatives = (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>);

/// What [`RuntimeRobot::inverse_dynamics_second_derivatives`] returns.
type SecondDerivatives = (
    Vec<DMatrix<f64>>,
    Vec<DMatrix<f64>>,
    Vec<DMatrix<f64>>,
    Vec<DMatrix<f64>>,
);

macro_rules! functions {
    ($($(#[$meaning:meta])* $name:ident($($argument:ident),*) -> $value:ty, $batch:ident;)*) => {
        /// The functions that have a method, each with its arguments.
        #[cfg(test)]
        pub(crate) const METHODS: &[(&str, &[&str])] =
            &[$((stringify!($name), &[$(stringify!($argument)),*])),*];

        /// Every function that is generated has a method of the same name here, for a state, and one for
        /// many: see [`evaluate`](RuntimeRobot::evaluate) and [`batch`](RuntimeRobot::batch), which have
        /// the errors of all of them. `q` in rad or m, rates per second, forces in N m or N.
        impl RuntimeRobot {
            $(
                $(#[$meaning])*
                ///
                /// # Errors
                ///
                /// Those of [`evaluate`](RuntimeRobot::evaluate).
                pub fn $name(&self $(, $argument: &[f64])*) -> Result<$value, EvaluationError> {
                    self.of_kind(stringify!($name), &[$($argument),*])
                }

                #[doc = concat!("[`", stringify!($name), "`](RuntimeRobot::", stringify!($name), ") at many states.")]
                ///
                /// # Errors
                ///
                /// Those of [`batch`](RuntimeRobot::batch).
                pub fn $batch(
                    &self,
                    $($argument: &[f64],)*
                    results: &mut [f64],
                ) -> Result<(), EvaluationError> {
                    self.batch(stringify!($name), &[$($argument),*], results)
                }
            )*
        }
    };
}

functions! {
    /// Mass matrix M(q), both triangles.
    mass_matrix(q) -> DMatrix<f64>, mass_matrix_batch;
    /// Coriolis and centrifugal vector V(q, qd).
    coriolis_vector(q, qd) -> DVector<f64>, coriolis_vector_batch;
    /// Gravity vector G(q).
    gravity_vector(q) -> DVector<f64>, gravity_vector_batch;
    /// Friction vector F(qd).
    friction_vector(qd) -> DVector<f64>, friction_vector_batch;
    /// Spring vector K(q).
    spring_vector(q) -> DVector<f64>, spring_vector_batch;
    /// Inverse dynamics tau = M qdd + V + G + K + F.
    inverse_dynamics(q, qd, qdd) -> DVector<f64>, inverse_dynamics_batch;
    /// Forward dynamics: qdd with M qdd + V + G + K + F = tau.
    forward_dynamics(q, qd, tau) -> DVector<f64>, forward_dynamics_batch;
    /// Kinetic energy, J.
    kinetic_energy(q, qd) -> f64, kinetic_energy_batch;
    /// Potential energy, J.
    potential_energy(q) -> f64, potential_energy_batch;
    /// Bias force V + G + K + F.
    bias_force(q, qd) -> DVector<f64>, bias_force_batch;
    /// Coriolis matrix C(q, qd) of the Christoffel symbols of the first kind.
    coriolis_matrix(q, qd) -> DMatrix<f64>, coriolis_matrix_batch;
    /// Coriolis coefficients B(q), columns in the order (1,2), (1,3), ..., (N-1,N).
    coriolis_coefficients(q) -> DMatrix<f64>, coriolis_coefficients_batch;
    /// Centrifugal coefficients C(q).
    centrifugal_coefficients(q) -> DMatrix<f64>, centrifugal_coefficients_batch;
    /// Homogeneous transform of the tip.
    forward_kinematics(q) -> DMatrix<f64>, forward_kinematics_batch;
    /// Homogeneous transforms of all link frames.
    link_poses(q) -> Vec<DMatrix<f64>>, link_poses_batch;
    /// Geometric Jacobian of the tip, rows vx vy vz wx wy wz.
    jacobian(q) -> DMatrix<f64>, jacobian_batch;
    /// d tau/dq and d tau/dqd.
    inverse_dynamics_derivatives(q, qd, qdd) -> TorqueDerivatives, inverse_dynamics_derivatives_batch;
    /// d qdd/dq, d qdd/dqd and the inverse of M.
    forward_dynamics_derivatives(q, qd, tau) -> AccelerationDerivatives, forward_dynamics_derivatives_batch;
    /// Regressor Y of the base inertial parameters.
    regressor(q, qd, qdd) -> DMatrix<f64>, regressor_batch;
    /// The base inertial parameters.
    base_parameters() -> DVector<f64>, base_parameters_batch;
    /// Forward dynamics by articulated bodies.
    forward_dynamics_aba(q, qd, tau) -> DVector<f64>, forward_dynamics_aba_batch;
    /// Joint torques J' w of a wrench at the tip, fx fy fz nx ny nz.
    wrench_torques(q, wrench) -> DVector<f64>, wrench_torques_batch;
    /// Velocity of the tip, vx vy vz wx wy wz.
    tool_velocity(q, qd) -> DVector<f64>, tool_velocity_batch;
    /// Acceleration of the tip.
    tool_acceleration(q, qd, qdd) -> DVector<f64>, tool_acceleration_batch;
    /// Rate of the geometric Jacobian.
    jacobian_rate(q, qd) -> DMatrix<f64>, jacobian_rate_batch;
    /// Geometric Jacobians of the origins of all link frames.
    link_jacobians(q) -> Vec<DMatrix<f64>>, link_jacobians_batch;
    /// Centre of mass of all links and the tool, m.
    center_of_mass(q) -> DVector<f64>, center_of_mass_batch;
    /// Jacobian of the centre of mass.
    center_of_mass_jacobian(q) -> DMatrix<f64>, center_of_mass_jacobian_batch;
    /// J M^-1 J', the inverse of the inertia that the tip has.
    operational_inertia_inverse(q) -> DMatrix<f64>, operational_inertia_inverse_batch;
    /// Generalized momentum M qd.
    generalized_momentum(q, qd) -> DVector<f64>, generalized_momentum_batch;
    /// C' qd - G - K - F.
    momentum_bias(q, qd) -> DVector<f64>, momentum_bias_batch;
    /// M qdd_r + C(q, qd) qd_r + G + K + F.
    passivity_torque(q, qd, qd_r, qdd_r) -> DVector<f64>, passivity_torque_batch;
    /// Regressor of M qdd_r + C qd_r + G.
    passivity_regressor(q, qd, qd_r, qdd_r) -> DMatrix<f64>, passivity_regressor_batch;
    /// Regressors of the kinetic and of the potential energy.
    energy_regressors(q, qd) -> (DVector<f64>, DVector<f64>), energy_regressors_batch;
    /// First and second time derivative of the torques.
    inverse_dynamics_rates(q, qd, qdd, jerk, snap) -> (DVector<f64>, DVector<f64>), inverse_dynamics_rates_batch;
    /// Second derivatives (d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd, dM/dq), each a matrix for every joint.
    inverse_dynamics_second_derivatives(q, qd, qdd) -> SecondDerivatives, inverse_dynamics_second_derivatives_batch;
}

impl RuntimeRobot {
    fn of_kind<V: crate::value::FromValue>(
        &self,
        function: &str,
        arguments: &[&[f64]],
    ) -> Result<V, EvaluationError> {
        let value = self.evaluate(function, arguments)?;
        // A method of several functions that was given the name of one has another value.
        V::from_value(value).ok_or_else(|| EvaluationError::NotDerived(function.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::METHODS;
    use dynamics_symbolic::Function;

    /// Every function of the table but `taylor_series`, which is no program over numbers.
    #[test]
    fn every_function_has_a_method() {
        let programs = Function::ALL.into_iter();
        let programs = programs.filter(|function| *function != Function::TaylorSeries);
        let expected: Vec<_> = programs
            .map(|function| {
                let arguments = function.arguments().iter().map(|argument| argument.name());
                (function.name(), arguments.collect::<Vec<_>>())
            })
            .collect();
        let methods = METHODS
            .iter()
            .map(|(name, arguments)| (*name, arguments.to_vec()));
        assert_eq!(methods.collect::<Vec<_>>(), expected);
    }
}
