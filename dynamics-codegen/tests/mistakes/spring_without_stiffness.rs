robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute { mass: 1, spring: { rest: 0.1 } },
        other: prismatic { mass: 1, spring: {} },
    ],
}
