robot_dynamics! {
    pub struct Unreadable { unused: f64 }
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1) },
    joints: 3,
    functions: [jacobian],
}
robot_dynamics! {
    pub struct Missing { unused: f64 }
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1) },
}
robot_dynamics! {
    pub struct Alone { unused: f64 }
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1), com: [1] },
    joints: [],
}
robot_dynamics! {
    pub struct Base;
    convention: modified,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: sphere(0.1) },
    joints: [
        base: revolute { mass: 1 },
        other: revolute { on: base, mass: 1 },
    ],
    frames: { base: { on: other, mass: 1 } },
}
