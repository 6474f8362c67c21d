robot_dynamics! {
    pub struct Arm;
    let half = 0,5;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { a: 0,4, mass: 1, inertia: { zz: 0,01 } },
        two: revolute { a: half, mass: 2,5, com: [0, 1, 0] },
        three: revolute { a: .5, mass: 1, com: [-.25, 0, .0] },
    ],
    lock: [one = 0,3],
}
