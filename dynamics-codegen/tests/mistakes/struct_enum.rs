robot_dynamics! {
    pub enum Arm { Left, Right }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
}
