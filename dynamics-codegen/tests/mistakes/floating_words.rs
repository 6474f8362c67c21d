robot_dynamics! {
    pub struct Misspelled;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floatng { mas: 3, inertia: sphere(0.1) },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct OfOthers;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: float { mass: 3 },
    joints: [],
}
robot_dynamics! {
    pub struct Alone;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: free_flyer,
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Fixed;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: fixed,
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Other;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: pelvis { mass: 3 },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Brackets;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating(mass: 3),
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Quotes;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: "floating",
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Braces;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: { floating: true, mass: 3 },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Behind;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1) } mass: 3,
    base: floating { mass: 3, inertia: sphere(0.1) },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
