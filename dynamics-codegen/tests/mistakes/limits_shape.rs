robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { mass: 1, limits: [PI] },
        two: revolute { mass: 1, limits: PI },
    ],
}
