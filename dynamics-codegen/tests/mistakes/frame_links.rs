robot_dynamics! {
    pub struct Arm { load: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
        elbow: revolute { a: 0.5, mass: 1 },
    ],
    frames: {
        hand: { xyz: [0, 0, 0.1], mass: load },
        thumb: { on: hand, mass: 1 },
        nail: { on: elbwo, mass: 1 },
        ring: { on: , mass: 1 },
        camera: { on: base, com: [0, 0, 1], rpy: [0, 0, 90] },
        lamp: { onn: elbow, mass: -1, a: 2 },
        "the palm": { on: wrist, inertia: sphere(0.1) },
        4: { on: elbow, mass: 1 },
        lens,
    },
}

robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [elbow: revolute { a: 0.5, mass: 1 }],
    frames: [hand: { on: elbow }],
}
