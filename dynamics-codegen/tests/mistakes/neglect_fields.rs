robot_dynamics! {
    pub struct Arm { l: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { mass: 1, limits: [0, l] },
        two: revolute { mass: l },
    ],
    neglect: 1%,
}
