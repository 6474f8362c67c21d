robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        base: fixed { d: 1 },
        turn: continuous { mass: 1 },
        revolute { mass: 1 },
        revolute { mass: 1 },
        prismatic { mass: 1 },
    ],
}
