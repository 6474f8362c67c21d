robot_dynamics! {
    pub struct Arm;
    convention: craig,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
}

robot_dynamics! {
    pub struct Other;
    convention: Modified,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
}
