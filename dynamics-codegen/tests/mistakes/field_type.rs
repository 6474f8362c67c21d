robot_dynamics! {
    pub struct Arm { mass: f32, length: Vec<f64>, g: f64 }
    convention: standard,
    gravity: [0, 0, -g],
    joints: [joint: revolute { mass: mass, com: [length, 0, 0] }],
}
