robot_dynamics! {
    struct Unknown;
    file: "tests/mistakes/files/locked.toml", allow: [odd_mass],
    joints: {
        elbo: { friction: { viscous: 0.1 } },
        tail: { friction: { viscous: 0.1 } },
        wrist: { frction: { viscous: 0.1 }, mass: 2, viscous: 0.1, gravity: [0, 0, 0] },
        wrist: { spring: { stiffness: 1 } },
        shoulder: { motor: { inertia: -1, gear_ratio: 10 }, friction: 0.1, spring: { rest: 1 } },
        finger: { limits: [1, 0], allow: [odd_limits, odd_anle] },
        2: { limits: [0, 1] },
        thumb: 3,
        jaw { limits: [0, 1] },
    },
}
robot_dynamics! {
    struct Urdf;
    file: "tests/mistakes/files/bare.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81], allow: [no_inertia],
    joints: {
        one: { limits: [1, 0] },
        two: { limits: [-90, 90], spring: { stiffness: 1, rest: 90 } },
        plate_joint: { friction: { viscous: 0.1 } },
        thre: { friction: { coulomb: missing } },
    },
}
robot_dynamics! {
    struct NoFile;
    convention: standard, gravity: [0, 0, -9.81],
    joints: { elbow: { friction: { viscous: 0.1 } } },
}
robot_dynamics! {
    struct NotRead;
    file: "tests/mistakes/files/nowhere.toml",
    joints: { elbow: { friction: { viscous: 0.1 } } },
}
robot_dynamics! {
    struct Rows;
    file: "tests/mistakes/files/locked.toml", allow: [odd_mass],
    joints: [elbow: revolute { mass: 1 }],
}
robot_dynamics! {
    struct Empty;
    file: "tests/mistakes/files/locked.toml", allow: [odd_mass],
    joints: {},
}
robot_dynamics! {
    struct InTheFile;
    file: "tests/mistakes/files/joints_beside.toml",
}
robot_dynamics! {
    struct Good { damping: f64 }
    joints: { wrist: { friction: { viscous: damping * 2 }, limits: [-1, 1] }, "thumb": {}, },
    file: "tests/mistakes/files/locked.toml", allow: [odd_mass],
}
robot_dynamics! {
    struct NamesInFront;
    file: "tests/mistakes/files/locked.toml", allow: [odd_mass],
    let damping = 0.5;
    joints: { wrist: { friction: { viscous: damping } } },
}
