robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { mass: 1, inertia: rod(1, axis = w) },
        two: revolute { mass: 1, inertia: sphere(1, axis = z) },
        three: revolute { mass: 1, inertia: cylinder(radius = 1, length = 2) },
        four: revolute { mass: 1, inertia: rod(axis = y) },
        five: revolute { mass: 1, inertia: cylinder(1, axis = x, 2) },
    ],
}
