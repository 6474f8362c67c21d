robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            mass: 1, inertia: cubiod(1, 2, 3)
        },
        other: revolute { mass: 1, inertia: m * l * l / 12 },
    ],
}
