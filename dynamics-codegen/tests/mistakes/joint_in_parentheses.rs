robot_dynamics! {
    pub struct Arm { l: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        revolute(j1, a: l),
        revolute(j2, a: l),
        _: revolute { mass: 1 },
    ],
}
