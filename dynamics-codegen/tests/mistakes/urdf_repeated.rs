robot_dynamics! {
    struct Repeated; file: "tests/mistakes/files/repeated.urdf", chain: ["base", "arm"], gravity: [0, 0, -9.81],
}
