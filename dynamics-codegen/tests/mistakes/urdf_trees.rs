robot_dynamics! {
    struct TwoRoots;
    file: "tests/mistakes/files/two_roots.urdf", gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct OneOfThem;
    file: "tests/mistakes/files/two_roots.urdf", chain: ["base"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Circle;
    file: "tests/mistakes/files/circle.urdf", gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct IntoTheCircle;
    file: "tests/mistakes/files/circle.urdf", chain: ["c"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct RootBesideACircle;
    file: "tests/mistakes/files/circle_beside.urdf", gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct TwoParents;
    file: "tests/mistakes/files/two_parents.urdf", gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct NoLinks;
    file: "tests/mistakes/files/planar.urdf", chain: [], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Planar;
    file: "tests/mistakes/files/planar.urdf", gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct PlanarOnTheWay;
    file: "tests/mistakes/files/planar.urdf", chain: ["world", "left.hand", "right.hand"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct PlanarBeside;
    file: "tests/mistakes/files/planar.urdf", chain: ["trunk", "left.hand", "cart"], gravity: [0, 0, -9.81],
    ignore: ["right-arm"],
}
robot_dynamics! {
    struct BehindThePlanarJoint;
    file: "tests/mistakes/files/planar.urdf", chain: ["trunk"], gravity: [0, 0, -9.81], ignore: [drift],
    functions: [mass_matrix],
}
robot_dynamics! {
    struct Links;
    file: "tests/mistakes/files/planar.urdf", gravity: [0, 0, -9.81],
    chain: ["trunk", "left.upper", "left.hand", "left.hnd", "right.hand", "right.hand"],
}
robot_dynamics! {
    struct OnTheWay;
    file: "tests/mistakes/files/planar.urdf", gravity: [0, 0, -9.81],
    chain: ["left.upper", "left.hand", "right.hand", "trunk"],
}
robot_dynamics! {
    struct Passed;
    file: "tests/mistakes/files/planar.urdf", gravity: [0, 0, -9.81],
    chain: ["trunk", "left.upper", "left.hand"],
}
robot_dynamics! {
    struct NothingMoves;
    file: "tests/mistakes/files/planar.urdf", gravity: [0, 0, -9.81], chain: ["right.upper", "right.hand"],
}
robot_dynamics! {
    struct NothingIsCarried;
    file: "tests/mistakes/files/planar.urdf", gravity: [0, 0, -9.81], chain: ["right.upper"],
}
robot_dynamics! {
    struct RestOfNothing;
    file: "tests/mistakes/files/planar.urdf", gravity: [0, 0, -9.81], ignore: [float, rest],
}
robot_dynamics! {
    struct RestOfWhatIsCarried;
    file: "tests/mistakes/files/planar.urdf", gravity: [0, 0, -9.81], chain: ["trunk"], lock: [rest = 0],
}
// The outermost links are named first.
robot_dynamics! {
    struct TwoTips;
    file: "tests/mistakes/files/planar.urdf", chain: ["trunk"], gravity: [0, 0, -9.81], ignore: [float],
    functions: [mass_matrix, jacobian],
}
// Two links end on the last one that moves, so that neither is the tip.
robot_dynamics! {
    struct TwoEnds;
    file: "tests/mistakes/files/ends.urdf", gravity: [0, 0, -9.81],
    functions: [jacobian], tool: { xyz: [0, 0, 0.1] },
}
