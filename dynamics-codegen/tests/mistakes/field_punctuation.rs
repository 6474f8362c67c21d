robot_dynamics! {
    pub struct Arm { m1: f64 m2: f64, pub m5 f64, m3: f64; m4: }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m1 + m2 + m3 + m4 + m5 }],
}
