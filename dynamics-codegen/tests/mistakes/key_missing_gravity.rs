robot_dynamics! {
    pub struct Arm;
    convention: modified,
    joints: [joint: revolute { mass: 1 }],
}
