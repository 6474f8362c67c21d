robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: [0, 0, 0.8],
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    tool: { xyz: [0, 0.1], rpy: [1, 2, 3, 4], com: 0.3, mass: 1 },
}
