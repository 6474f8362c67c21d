robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    bounds: tigth,
    joints: [one: revolute { mass: 1, limits: [-1, 1] }],
    functions: [mass_matrix],
}
