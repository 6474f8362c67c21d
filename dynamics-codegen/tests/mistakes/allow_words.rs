robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { mass: 1, allow: [odd_angles, heavy], alpha: 1.57 },
        two: revolute { mass: 1, allow: odd_mass },
        three: revolute { mass: 1, allow: [odd_gravity] },
    ],
    allow: [odd_gravty, odd_mass,],
    allow: [odd_mass],
}
