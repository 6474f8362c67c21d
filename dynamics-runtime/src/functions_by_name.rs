//! What the compiler says about a method that was not asked for: written by the engine's test `functions`.

/// No method of a robot exists that its `functions:` do not name. About `arm.jacobian(&q)` of another one
/// the compiler says that there is no such method, and that a trait has one of this name: this trait, whose
/// name says what to do. It is implemented by nothing, so that no method of it is ever offered.
#[allow(missing_docs)] // The robots' own methods have the documentation.
pub trait AddItsNameToFunctions {
    fn mass_matrix(&self);
    fn coriolis_vector(&self);
    fn gravity_vector(&self);
    fn friction_vector(&self);
    fn spring_vector(&self);
    fn inverse_dynamics(&self);
    fn forward_dynamics(&self);
    fn kinetic_energy(&self);
    fn potential_energy(&self);
    fn bias_force(&self);
    fn coriolis_matrix(&self);
    fn coriolis_coefficients(&self);
    fn centrifugal_coefficients(&self);
    fn forward_kinematics(&self);
    fn link_poses(&self);
    fn jacobian(&self);
    fn inverse_dynamics_derivatives(&self);
    fn forward_dynamics_derivatives(&self);
    fn regressor(&self);
    fn base_parameters(&self);
    fn forward_dynamics_aba(&self);
    fn taylor_series(&self);
    fn wrench_torques(&self);
    fn tool_velocity(&self);
    fn tool_acceleration(&self);
    fn jacobian_rate(&self);
    fn link_jacobians(&self);
    fn center_of_mass(&self);
    fn center_of_mass_jacobian(&self);
    fn operational_inertia_inverse(&self);
    fn generalized_momentum(&self);
    fn momentum_bias(&self);
    fn passivity_torque(&self);
    fn passivity_regressor(&self);
    fn energy_regressors(&self);
    fn inverse_dynamics_rates(&self);
    fn inverse_dynamics_second_derivatives(&self);
}
