robot_dynamics! {
    pub struct Two;
    convention: standard,
    gravity: [0, -9.81],
    joints: [joint: revolute { mass: 1 }],
}

robot_dynamics! {
    pub struct Scalar;
    convention: standard,
    gravity: 9.81,
    joints: [joint: revolute { mass: 1 }],
}

robot_dynamics! {
    pub struct Tuple;
    convention: standard,
    gravity: (0, 0, -9.81),
    joints: [joint: revolute { mass: 1 }],
}
