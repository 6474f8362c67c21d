robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: { rpy: [90, 0, -45] },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    tool: { rpy: [0, 30deg, 180] },
}
