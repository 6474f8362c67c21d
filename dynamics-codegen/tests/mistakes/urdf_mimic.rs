robot_dynamics! {
    struct Circle;
    file: "tests/mistakes/files/mimic.urdf", chain: ["base_link", "hand"],
    ignore: [banner], lock: [wrist = 0.1], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct LeaderBeside;
    file: "tests/mistakes/files/mimic.urdf", chain: ["upper", "hand"],
    ignore: [banner, left_finger, right_finger], lock: [elbow = 0.1], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct FollowerBeside;
    file: "tests/mistakes/files/mimic.urdf", chain: ["base_link", "upper"],
    gravity: [0, 0, -9.81], ignore: [wrist], lock: [mast = 0.2],
}
robot_dynamics! {
    struct Still;
    file: "tests/mistakes/files/mimic.urdf", chain: ["base_link", "lower"],
    ignore: [wrist, mast], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Twice;
    file: "tests/mistakes/files/still.urdf", chain: ["base_link", "lower"], ignore: [grip],
    couple: [elbow = 2 * shoulder], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct NoSuchLeader;
    file: "tests/mistakes/files/still.urdf", chain: ["base_link", "tip"], gravity: [0, 0, -9.81],
}
