robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: { xyz: [0, 0, 1] },
    base: { rpy: [0, 0, 1] },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
