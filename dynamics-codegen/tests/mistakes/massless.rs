robot_dynamics! {
    pub struct Massless;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { a: 1 }, two: revolute { a: 1, mass: 0 }],
}
robot_dynamics! {
    pub struct Geometry;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { a: 1 }, two: revolute { a: 1 }],
    functions: [forward_kinematics, jacobian],
}
robot_dynamics! {
    pub struct Insisted;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { a: 1 }],
    functions: [mass_matrix],
    allow: [no_inertia],
}
robot_dynamics! {
    pub struct OddMass;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { a: 1 }],
    functions: [mass_matrix],
    allow: [odd_mass],
}
