robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute {
            mass: 1,
            friction: { coulomb: { positive: 0.5, negative: 0.9 }, stribeck: { static: 0.8, velocity: 0 } },
        },
        two: revolute { mass: 1, friction: { stribeck: { static: -0.1, velocity: -1 } } },
        three: revolute { mass: 1, friction: { coulomb: 1, stribeck: { velocity: 0.01 } } },
        four: revolute { mass: 1, friction: { coulomb: 1, stribeck: { static: 2 } } },
        five: revolute { mass: 1, friction: { coulomb: 1, stribeck: 2 } },
        six: revolute { mass: 1, friction: { coulomb: 1, strbeck: { statc: 2, velocty: 0.1 } } },
    ],
}
