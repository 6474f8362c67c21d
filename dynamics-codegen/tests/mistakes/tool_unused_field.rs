robot_dynamics! {
    pub struct Arm { height: f64, load: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    base: { xyz: [0, 0, height] },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    tool: { mass: 2 },
}
