robot_dynamics! {
    pub struct Arm { m1: f64, m2: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m1 }],
}
