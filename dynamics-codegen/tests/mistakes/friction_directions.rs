robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { mass: 1, friction: { coulomb: { positive: 0.5 } } },
        two: revolute { mass: 1, friction: { coulomb: { positive: 0.5, negative: -0.4 } } },
        three: revolute { mass: 1, friction: { coulomb: { positve: 0.5, backwards: 0.4 } } },
        four: revolute { mass: 1, friction: { coulomb: {} } },
    ],
}
