robot_dynamics! {
    pub struct Arm { m, l: f64, d: f64 = 1.0, r }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m, a: l, d: d + r }],
}
