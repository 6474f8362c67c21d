robot_dynamics! {
    pub struct Hand;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        finger_1: prismatic { mass: 0.1 },
        finger_2: prismatic { mass: 0.1 },
    ],
    coupled: [finger_2 = -finger_1],
    couple: [finger_2 = -finger_1],
    couple: [finger_2 = finger_1],
}
