robot_dynamics! {
    pub struct Functions;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1) },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    functions: [coriolis_coefficients, centrifugal_coefficients, taylor_series, both = (mass_matrix, coriolis_coefficients), inverse_kinematics],
    neglect: 1%,
}
robot_dynamics! {
    pub struct Alone;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1) },
    joints: [],
    tool: { xyz: [0, 0, 1], mass: 1 },
    functions: [jacobian, link_poses, inverse_kinematics],
}
robot_dynamics! {
    pub struct Tips;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1) },
    joints: [
        left: revolute { a: 0.5, mass: 1 },
        right: revolute { on: base, a: 0.5, mass: 1 },
    ],
    functions: [jacobian, inverse_kinematics],
}
