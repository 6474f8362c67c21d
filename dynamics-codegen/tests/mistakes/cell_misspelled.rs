robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            mas: 1,
            aplha: PI/2,
            con: [0, 0, 1],
            frictions: { viscous: 0.1 },
        },
    ],
}
