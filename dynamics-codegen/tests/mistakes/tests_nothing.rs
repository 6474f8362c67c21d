robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
    ],
    functions: [regressor],
    tests: true,
}

robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
    ],
    functions: [base_parameters],
    tests: true,
}
