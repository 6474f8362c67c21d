robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
        elbow: revolute { a: 0.5, mass: 1 },
    ],
    frames: {
        hand: { on: elbow, mass: 1 },
        elbow: { on: elbow, mass: 1 },
        base: { on: elbow, mass: 1 },
        hand: { on: shoulder, mass: 1 },
        "left hand": { on: shoulder, mass: 1 },
    },
}
