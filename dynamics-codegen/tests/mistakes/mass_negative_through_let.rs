robot_dynamics! {
    pub struct Arm;
    let total = 3;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: total - 10 * PI / 9 }],
}
