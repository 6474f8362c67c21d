robot_dynamics! {
    pub struct Arm;
    units: [mm, kg, s],
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
}
