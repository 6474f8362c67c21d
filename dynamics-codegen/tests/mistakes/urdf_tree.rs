robot_dynamics! {
    struct NoChain; file: "tests/mistakes/files/tree.urdf", gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct UnknownLinks;
    file: "tests/mistakes/files/tree.urdf", chain: ["base_lnk", "tool"], ignore: [whel], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Inwards;
    file: "tests/mistakes/files/tree.urdf", chain: ["hand", "upper"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Empty;
    file: "tests/mistakes/files/tree.urdf", chain: ["lower", "lower"], ignore: [grip, elbow], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Tree;
    file: "tests/mistakes/files/tree.urdf", chain: ["base_link", "hand"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Values;
    file: "tests/mistakes/files/tree.urdf", chain: ["base_link", "upper"], ignore: [wheel, elbow],
    allow: [unphysical_inertia], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Mimic;
    file: "tests/mistakes/files/tree.urdf", chain: ["hand", "finger"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Entries { x: f64 }
    file: "tests/mistakes/files/tree.urdf", chain: ["base_link"], round_angles: 3, gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Locks { x: f64 }
    file: "tests/mistakes/files/tree.urdf", chain: ["base_link", "upper"],
    ignore: [wheel, shoulder], lock: [elbow = x, grip = 0.1], gravity: [0, 0, -9.81],
}

robot_dynamics! {
    struct NoJoints;
    file: "tests/mistakes/files/no_joints.urdf", chain: ["base", "tip"],
}

robot_dynamics! {
    struct OddNames;
    file: "tests/mistakes/files/odd_names.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
}
