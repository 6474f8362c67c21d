robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            mass: 1, spring: { stifness: 200, rset: 0.1, k: 3, damping: 1 }, stiffness: 3
        },
    ],
}
