robot_dynamics! {
    pub struct NoWrist;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        q1: revolute { d: 0.6, alpha: PI/2 },
        q2: revolute { a: 0.4 },
        q3: revolute { a: 0.02, d: 0.15, alpha: -PI/2 },
        q4: revolute { d: 0.4, alpha: PI/2 },
        q5: revolute { a: 0.01, alpha: -PI/2 },
        q6: revolute {},
    ],
    functions: [forward_kinematics, inverse_kinematics],
}

robot_dynamics! {
    pub struct Quartic;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        q1: revolute { a: 0.1, alpha: 1 },
        q2: revolute { a: 0.4, alpha: 0.7 },
        q3: revolute { a: 0.02, d: 0.15, alpha: -PI/2 },
        q4: revolute { d: 0.4, alpha: PI/2 },
        q5: revolute { alpha: -PI/2 },
        q6: revolute {},
    ],
    functions: [inverse_kinematics],
}

robot_dynamics! {
    pub struct Five;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        q1: revolute {},
        q2: revolute { alpha: PI/2 },
        q3: revolute { a: 0.4 },
        q4: revolute { a: 0.4, alpha: PI/4 },
        q5: revolute { alpha: PI/2 },
    ],
    functions: [inverse_kinematics],
}

robot_dynamics! {
    pub struct Redundant;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        q1: revolute { d: 0.333 },
        q2: revolute { alpha: -PI/2 },
        q3: revolute { alpha: PI/2, d: 0.316 },
        q4: revolute { alpha: PI/2, a: 0.0825 },
        q5: revolute { alpha: -PI/2, a: -0.0825, d: 0.384 },
        q6: revolute { alpha: PI/2 },
        q7: revolute { alpha: PI/2, a: 0.088 },
    ],
    functions: [inverse_kinematics],
}

robot_dynamics! {
    pub struct Torso;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {},
        left_elbow: revolute { on: waist, a: 0.3 },
        right_elbow: revolute { on: waist, a: 0.3 },
    ],
    frames: {
        left_hand: { on: left_elbow, xyz: [0.3, 0, 0] },
    },
    functions: [
        inverse_kinematics(left_hand),
        inverse_kinematics,
        inverse_kinematics(left),
        inverse_kinematics(left_hand),
        inverse = (inverse_kinematics, jacobian(left_hand)),
        inverse_kinematics = (jacobian(left_hand), forward_kinematics(left_hand)),
        inverse_kinematic,
    ],
}

robot_dynamics! {
    pub struct Fingers;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {},
        left_elbow: revolute { on: waist, a: 0.3 },
        right_elbow: revolute { on: waist, a: 0.3 },
    ],
    frames: {
        left_hand: { on: left_elbow, xyz: [0.3, 0, 0] },
    },
    functions: [inverse_kinematics(left_hand)],
}

robot_dynamics! {
    pub struct Follower;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        q1: revolute {},
        q2: revolute { a: 0.3 },
    ],
    tool: { xyz: [0.3, 0, 0] },
    couple: [q2 = 2 * q1],
    functions: [inverse_kinematics],
}

robot_dynamics! {
    pub struct Flying;
    convention: modified,
    gravity: [0, 0, -9.81],
    base: floating { mass: 3, inertia: { xx: 1, yy: 1, zz: 1 } },
    joints: [
        q1: revolute {},
        q2: revolute { a: 0.3 },
    ],
    tool: { xyz: [0.3, 0, 0] },
    functions: [inverse_kinematics],
}

robot_dynamics! {
    pub struct Ball;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        q1: revolute {},
        q2: revolute { alpha: PI/2 },
        q3: revolute { alpha: -PI/2 },
    ],
    functions: [inverse_kinematics],
}

robot_dynamics! {
    pub struct Huge;
    convention: standard,
    gravity: [0, 0, -9.81],
    allow: [odd_length],
    joints: [
        q1: revolute { d: 1e200, alpha: PI/2 },
        q2: revolute { a: 1e200 },
        q3: revolute { a: 3e200 },
    ],
    functions: [inverse_kinematics],
}
