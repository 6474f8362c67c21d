robot_dynamics! {
    pub struct Torso;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { mass: 9 },
        left_elbow: revolute { on: waist, mass: 1 },
        right_elbow: revolute { on: waist, mass: 1 },
    ],
    frames: {
        left_hand: { on: left_elbow, xyz: [0.3, 0, 0] },
        "left-hand": { on: left_elbow, xyz: [0.3, 0, 0] },
        rate: { on: right_elbow },
        batch: { on: right_elbow },
        camera: { on: waist },
        load: { on: waist, mass: 1 },
    },
    functions: [
        jacobian(left_hand),
        jacobian("left-hand"),
        jacobian(rate),
        jacobian(batch),
        jacobian,
        mass_matrix(left_hand),
        mass_matrix,
        mass_matrix,
        tool_velocity(left_hand),
        tool_velocity(left_hand),
        tool_velocity_load = (mass_matrix, forward_kinematics(load)),
        tool_velocity(load),
        grasp = (jacobian(left_hand), mass_matrix, jacobian(left_hand), forward_kinematics, mass_matrix(load)),
        single = (jacobian(load)),
        default(load),
    ],
}

robot_dynamics! {
    pub struct Torso;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { mass: 9 },
        left_elbow: revolute { on: waist, mass: 1 },
        right_elbow: revolute { on: waist, mass: 1 },
        lift: prismatic { on: base, mass: 1, limits: [0, 1] },
    ],
    tool: { xyz: [0, 0, 0.1], mass: 1 },
    functions: [jacobian, mass_matrix, pair = (mass_matrix, forward_kinematics)],
}

// Mistakes that follow from an unknown frame are not reported.
robot_dynamics! {
    pub struct Arm;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [elbow: revolute { mass: 1 }, wrist: revolute { a: 1, mass: 1 }],
    frames: { left_hand: { on: wrist }, camera: { on: elbow } },
    functions: [
        jacobian(left_hnad), jacobian(wrist), forward_kinematics(lamp), jacobian(), jacobian(left_hand, camera),
        jacobian(left-hand), jacobian(3), jacobian[left_hand], jacobain(left_hand), jacobian("left_hand" camera),
    ],
}

robot_dynamics! {
    pub struct Arm;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [elbow: revolute { mass: 1 }, wrist: revolute { a: 1, mass: 1 }],
    functions: [jacobian(hand)],
}

robot_dynamics! {
    pub struct Arm;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [elbow: revolute { mass: 1 }, wrist: revolute { a: 1, mass: 1 }],
    frames: { hand: { on: wrist }, "": { on: wrist }, _: { on: wrist } },
}

robot_dynamics! {
    pub struct Arm;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [elbow: revolute { mass: 1 }, wrist: revolute { a: 1, mass: 1 }],
    frames: { hand: { on: wrist }, "the palm": { on: wrist }, idle: { on: elbow, xyz: [0, 1, 0] } },
    functions: [mass_matrix, pair = (mass_matrix, jacobian(hand))],
}
