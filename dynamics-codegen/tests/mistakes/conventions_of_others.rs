robot_dynamics! {
    pub struct Craig;
    convention: mdh,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { mass: 1 }],
}
robot_dynamics! {
    pub struct Either;
    convention: dh,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { mass: 1 }],
}
