robot_dynamics! {
    struct Arm;
    file: "tests/mistakes/files/arm.toml",
    convention: modified,
    gravity: [0, 0, -1.62],
    joints: [elbow: revolute { mass: 1 }],
    functions: [jacobian],
    chain: ["base", "tool"],
    lock: [sholder = 0.3],
}
robot_dynamics! {
    struct Chain;
    convention: standard,
    gravity: [0, 0, -9.81],
    chain: ["base", "tool"],
    ignore: [finger],
    joints: [elbow: revolute { mass: 1 }],
}
