robot_dynamics! {
    struct Unnamed;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Numbers;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
    lock: [2 = 0, left = 0.03], ignore: [3],
}
robot_dynamics! {
    struct NumbersOfLinks;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", 2], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Rest;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
    ignore: rest,
}
robot_dynamics! {
    struct RestInBrackets;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
    ignore: [rest], allow: [odd_limits],
}
robot_dynamics! {
    struct RestLocked;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
    lock: [rest = 0], ignore: ["3"], allow: [odd_limits],
}
robot_dynamics! {
    struct RestTwice;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
    lock: [rest = 0], ignore: rest,
}
robot_dynamics! {
    struct OutOfLimits;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
    lock: [left = 0.02, "2" = 0], ignore: ["3"], allow: [odd_limits],
}
robot_dynamics! {
    struct FollowersOutOfLimits;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
    lock: [left = 0.055, "2" = 0], ignore: ["3"], allow: [odd_limits],
}
robot_dynamics! {
    struct Within;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
    lock: [left = 0.03, rest = 0.5], ignore: ["3"], allow: [odd_limits],
}
robot_dynamics! {
    struct OnTheChain;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "thumb_link"], gravity: [0, 0, -9.81],
    lock: [left = 0.055], ignore: [right, rest], allow: [odd_limits],
}
robot_dynamics! {
    struct LeaderOnTheChain;
    file: "tests/mistakes/files/gripper.urdf", chain: ["base", "thumb_link"], gravity: [0, 0, -9.81],
    lock: ["1" = 0.1, rest = 0], ignore: ["3"],
}
