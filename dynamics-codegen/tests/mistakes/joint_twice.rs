robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        elbow: revolute { mass: 1 },
        elbow: revolute { a: 1, mass: 1 },
    ],
}
