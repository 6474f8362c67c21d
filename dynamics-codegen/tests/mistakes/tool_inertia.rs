robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { a: 0.5, mass: 1 }],
    tool: { mass: 1, inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 } },
}
