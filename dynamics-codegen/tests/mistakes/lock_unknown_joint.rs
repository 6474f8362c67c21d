robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
        elbow: revolute { a: 0.5, mass: 1, limits: [-2, 2] },
    ],
    lock: [elbo = 0.3, showlder = 1],
}
