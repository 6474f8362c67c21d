robot_dynamics! {
    struct Default;
    file: "tests/mistakes/files/bare.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Several;
    file: "tests/mistakes/files/bare.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
    functions: [jacobian, both = (forward_kinematics, mass_matrix)],
}
robot_dynamics! {
    struct CenterOfMass;
    file: "tests/mistakes/files/bare.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
    functions: [center_of_mass], lock: [four = 0.1],
}
robot_dynamics! {
    struct LockedToTheNext;
    file: "tests/mistakes/files/bare.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
    lock: [two = 0.1, four = 0],
}
robot_dynamics! {
    struct Geometry;
    file: "tests/mistakes/files/bare.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
    functions: [forward_kinematics, link_poses, both = (jacobian, tool_velocity), wrench_torques, friction_vector],
}
robot_dynamics! {
    struct Allowed;
    file: "tests/mistakes/files/bare.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
    functions: [default, jacobian], allow: [no_inertia],
}
robot_dynamics! {
    struct OnARow;
    file: "tests/mistakes/files/bare.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
    tool: { mass: 1, allow: [no_inertia] }, functions: [jacobian],
}
