robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { mass: 1 }],

    /// Another one.
    pub struct Second { m: f64 }
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { mass: n }],
}
