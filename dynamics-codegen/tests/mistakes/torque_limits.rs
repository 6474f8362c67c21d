robot_dynamics! {
    pub struct Arm { strength: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { mass: 1, torque_limit: 0, velocity_limit: -1 },
        two: revolute { mass: 1, torque_limit: strength, velocity_limit: [1, 2] },
        three: revolute { mass: 1, torque_limt: 3, effort: 4, velocity_limit: 2, velocity_limit: 3 },
    ],
}
