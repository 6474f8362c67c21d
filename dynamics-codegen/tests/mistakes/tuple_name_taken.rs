robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
    functions: [mass_matrix = (coriolis_vector, gravity_vector), table = (mass_matrix, gravity_vector), DOF = (mass_matrix, gravity_vector)],
}
robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
    functions: [control = (mass_matrix, gravity_vector), jacobian, control = (jacobian, gravity_vector)],
}
