robot_dynamics! {
    pub struct Hand { width: f64 }
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        turn: revolute { mass: 1, com: [width, 0, 0] },
        finger_1: prismatic { alpha: PI/2, mass: 0.1 },
        finger_2: prismatic { mass: 0.1, limits: [0, 0.1], torque_limit: 5, velocity_limit: 1 },
        thumb: revolute { a: 0.1, mass: 0.1 },
    ],
    couple: [finger_2 = -finger_1],
}
robot_dynamics! {
    struct Beside;
    file: "tests/mistakes/files/still.urdf", chain: ["base_link", "lower"], ignore: [grip],
    gravity: [0, 0, -9.81], joints: { elbow: { limits: [-1, 1] } },
}
