robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
    functions: [match = (mass_matrix, gravity_vector)],
}
robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
    functions: [3 = (mass_matrix, gravity_vector)],
}
