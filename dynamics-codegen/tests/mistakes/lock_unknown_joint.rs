robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
        elbow: revolute { a: 0.5, mass: 1, limits: [-2, 2] },
    ],
    lock: [elbo = 0.3, showlder = 1],
}

// Consequences of the slip are not told.
robot_dynamics! {
    pub struct Fork;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { mass: 1 },
        left: revolute { on: waist, mass: 1 },
        right: revolute { on: waist, mass: 1 },
    ],
    functions: [jacobian],
    lock: [lft = 0],
}

robot_dynamics! {
    pub struct Gripper;
    file: "../tests/data/urdf/panda.urdf", chain: ["panda_link0", "panda_hand"],
    lock: [panda_finger_joint_1 = 0], ignore: [panda_fingerjoint2],
}
