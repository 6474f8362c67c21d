robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
    functions: [control = (mass_matrx, gravity), other = (jacobian, 3, mass_matrix)],
}
robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
    functions: [control = (default, jacobian)],
}
