robot_dynamics! {
    pub struct Arm { height: f64, tilt: f64, load: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    base: { xyz: [0, 0, hight], rpy: [0, tilt / (tilt - tilt), 0] },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    tool: { xyz: [length, 0, 0], mass: load },
}
