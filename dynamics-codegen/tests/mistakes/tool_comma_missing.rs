robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    tool: { xyz: [0, 0, 0.1] mass: 2, com: [0, 0, 0.05] },
}
