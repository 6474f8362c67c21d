robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    mount: { position: [0, 0, 1], orientation: [0, 0, 1] },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    payload: { mass: 2, cog: [0, 0, 0.1] },
}
