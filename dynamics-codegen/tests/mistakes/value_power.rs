robot_dynamics! {
    pub struct Arm { l: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: l**2, a: (2 + l)**2 }],
}
