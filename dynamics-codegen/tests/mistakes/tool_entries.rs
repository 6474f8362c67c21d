robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    tool: { inertai: sphere(0.1), mas: 2, mass: 3, a: 1, friction: { viscous: 1 } },
}
