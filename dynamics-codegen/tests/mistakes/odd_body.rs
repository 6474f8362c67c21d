robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9810],
    joints: [
        one: revolute { a: 0.4, com: [0.2, 0, 0], inertia: { xx: 1, yy: 1, zz: 1 } },
        two: revolute { inertia: { xx: 1, yy: 1, zz: 1, xy: 0.1 } },
        three: revolute { mass: 1, com: [-200, 0, 0] },
        four: revolute { mass: 0, com: [0.2, 0, 0], inertia: { xx: 1, yy: 1, zz: 1 } },
        five: revolute { inertia: { yy: 0.35 } },
    ],
    tool: { com: [0, 0, 0.1], inertia: { xx: 1, yy: 1, zz: 1 } },
}
