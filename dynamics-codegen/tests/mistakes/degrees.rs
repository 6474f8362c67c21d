robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { twist: PI/2, offset: 1 },
        shoulder: revolute { alpha: -90, theta: 45deg },
        elbow: rotary { alpha: 180, a: 431.8mm },
    ],
    functions: [tau],
}
