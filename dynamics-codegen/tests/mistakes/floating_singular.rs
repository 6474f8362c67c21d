robot_dynamics! {
    pub struct Nothing;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating,
    joints: [],
}
robot_dynamics! {
    pub struct OneLink;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating {},
    joints: [joint: revolute { mass: 1, com: [0.1, 0, 0], inertia: sphere(0.1) }],
}
robot_dynamics! {
    pub struct Point;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3 },
    joints: [joint: revolute { mass: 1, com: [0.1, 0, 0], inertia: sphere(0.1) }],
}
robot_dynamics! {
    pub struct NoJoints;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [],
}
