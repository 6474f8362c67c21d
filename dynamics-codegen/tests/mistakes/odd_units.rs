robot_dynamics! {
    pub struct Millimetres;
    convention: standard,
    gravity: [9.81, 9.81, 9.81],
    joints: [
        one: revolute { a: 250, d: 120, mass: 4, com: [-125, 0, 0] },
        two: revolute { a: 500, theta: 5, mass: 3, com: [-0.25, 0, 0] },
        three: revolute { a: 90, mass: 1, motor: { inertia: 2e-4, gear_ratio: 0.01 } },
    ],
    tool: { xyz: [0, 0, 160], mass: 1 },
}
robot_dynamics! {
    pub struct Grams;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { a: 1, mass: 2000, com: [-0.5, 0, 0], inertia: rod(1) },
        two: revolute { a: 0.5, mass: 1200, com: [-0.25, 0, 0] },
        three: revolute { mass: 1 },
    ],
    tool: { mass: 1 },
}
robot_dynamics! {
    pub struct OfTheTable;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { a: 1, mass: 2000, com: [-0.5, 0, 0], inertia: rod(1), allow: [odd_length] },
        two: revolute { a: 0.5, mass: 1200, com: [-0.25, 0, 0] },
    ],
}
robot_dynamics! { struct Toml; file: "tests/mistakes/files/units.toml" }
robot_dynamics! { struct Json; file: "tests/mistakes/files/units.json" }
robot_dynamics! {
    struct Urdf;
    file: "tests/mistakes/files/units.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct UrdfInRadians;
    file: "tests/mistakes/files/units.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81], allow: [odd_angle],
}
robot_dynamics! {
    struct Heavy;
    file: "tests/mistakes/files/grams.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Allowed;
    file: "tests/mistakes/files/units.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
    functions: [mass_matrix], allow: [odd_angle, odd_length],
}
robot_dynamics! {
    struct AllowedMass;
    file: "tests/mistakes/files/grams.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
    functions: [mass_matrix], allow: [odd_mass],
}
