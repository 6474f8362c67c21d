robot_dynamics! {
    pub struct Torso;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { at: { xyz: [0, 0, 1] }, gamma: PI/2, b: 0.2, mass: 9 },
        left_shoulder: revolute { on: waist, gamma: , mass: 2 },
        left_elbow: revolute { gamma: 90, b: -, mass: 1 },
        left_wrist: revolute { at: [0, 0, 1], mass: 1 },
        left_hand: revolute { at: { xyz: [0, 0], yaw: 1 }, mass: 1 },
        left_thumb: revolute { at: { xyz: [0, 0, length], rpy: [0, 0, 1.57] }, mass: 1, allow: [odd_angle] },
    ],
}

robot_dynamics! {
    pub struct Torso;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { b: 0.2, mass: 9 },
        left_shoulder: revolute { on: waist, gamma: PI/2, b: 0.2, mass: 2 },
    ],
}
