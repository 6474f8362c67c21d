robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        both: revolute { a: 1, mass: 1, com: [0, 0, 0], inertia: sphere(1), inertia_at_origin: { xx: 1 } },
        without_com: revolute { mass: 1, inertia_at_origin: { xx: 1, yy: 1, zz: 1 } },
        without_mass: revolute { inertia_at_origin: { xx: 1, yy: 1, zz: 1 } },
        solid: revolute { mass: 1, com: [0, 0, 0], inertia_at_origin: sphere(1) },
        too_small: revolute { mass: 1, com: [1, 0, 0], inertia_at_origin: { xx: 1, yy: 1, zz: 0.5 } },
        good: revolute { mass: 1, com: [1, 0, 0], inertia_at_origin: { xx: 1, yy: 2, zz: 2 } },
    ],
    tool: { mass: 1, inertia_at_origin: { xx: 1, yy: 1, zx: 1 } },
}
