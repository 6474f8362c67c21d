robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    tool: { inertia: sphere(-0.1) },
}
robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    tool: { mass: 1, inertia: ball(0.1), allow: [unphysical_inertai] },
}
