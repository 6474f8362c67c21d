robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: { xyz: [0, 0, 1], ryp: [0, 0, 0], mass: 2, rpy: [0, 0, 1], xyz: [0, 0, 2] },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
