robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravty: [0, 0, -9.81],
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute { masss: 1, mass: 2, com: [0, 0, 1], con: [0, 0, 2] },
    ],
}
