robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        turn: revolute { mass: 1, friction: { coulomb: 1, stribeck: { static: 2, velocity: 0.1 } } },
    ],
    functions: [mass_matrix, taylor_series],
}
