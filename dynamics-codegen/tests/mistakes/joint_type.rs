robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one { mass: 1 },
        two: { mass: 1 },
        three: revolut { mass: 1 },
        four: linear { mass: 1 },
        revolute { mass: 1 },
        "six": revolute { mass: 1 },
        seven: revolute,
        eight: revolute(mass: 1),
    ],
}
