//! An arm whose gravity takes three angles and few operations: what its sines cost shows.

use robot_dynamics::nalgebra::Vector3;
use robot_dynamics::robot_dynamics;

robot_dynamics! {
    /// A waist that no force of gravity turns, and three links in one plane.
    pub(crate) struct ThreeJoints;

    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { mass: 7, com: [0.3, 0.01, 0], inertia: rod(0.6) },
        elbow: revolute { a: 0.6, mass: 3, com: [0.2, 0, 0.02], inertia: rod(0.5) },
        wrist: revolute { a: 0.5, alpha: PI/2, mass: 1, com: [0.1, 0.02, 0], inertia: rod(0.2) },
    ],
    functions: [
        default, bias_force, coriolis_matrix, coriolis_coefficients, centrifugal_coefficients,
        forward_kinematics, link_poses, jacobian, jacobian_rate, tool_velocity, tool_acceleration,
        link_jacobians, center_of_mass, center_of_mass_jacobian, generalized_momentum, momentum_bias,
        inverse_dynamics_derivatives, regressor,
    ],
}

#[inline(never)]
pub(crate) fn gravity_at_three_angles(q: &Vector3<f64>) -> Vector3<f64> {
    ThreeJoints.gravity_vector(q)
}
