robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    convention: modified,
    joints: [joint: revolute { mass: 1 }],
    gravity: [0, 0, 0],
}
