robot_dynamics! {
    pub struct Placed;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1), xyz: [0, 0, 1], rpy: [0, 0, 0], position: [0, 0, 1], a: 3 },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Body;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: -3, com: [0, 0], inertia: { xx: 1, yy: 1, zz: 5 }, allow: [odd], mass: 2 },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Unphysical;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: { xx: 1, yy: 1, zz: 5 } },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct AtOrigin;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia_at_origin: { xx: 1, yy: 1, zz: 1 } },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Massless;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { inertia: sphere(0.1), com: [0, 0, 0.1] },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Far;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, com: [30, 0, 0], inertia: sphere(0.1) },
    joints: [joint: revolute { a: 0.5, mass: 1 }],
}
robot_dynamics! {
    pub struct Grams;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3000, inertia: sphere(0.1) },
    joints: [joint: revolute { a: 0.1, mass: 1 }],
}
// A quarter turn that is none, and a mass of ten powers too many.
robot_dynamics! {
    pub struct Turned;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1) },
    joints: [joint: revolute { at: { xyz: [0, 0, 0.1], rpy: [0, 1.5708, 0] }, a: 0.1, mass: 1 }],
}
robot_dynamics! {
    pub struct Heavy;
    convention: standard,
    gravity: [0, 0, -9.81],
    base: floating { mass: 30000000000, inertia: sphere(0.1) },
    joints: [joint: revolute { a: 0.1, mass: 1 }],
}
