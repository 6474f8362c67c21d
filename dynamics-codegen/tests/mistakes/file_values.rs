robot_dynamics! { struct Values; file: "tests/mistakes/files/values.toml" }
robot_dynamics! { struct Places; file: "tests/mistakes/files/places.toml" }
robot_dynamics! { struct Published; file: "tests/mistakes/files/places.json" }
robot_dynamics! {
    struct Degrees;
    file: "tests/mistakes/files/degrees.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
}
robot_dynamics! {
    struct Turns;
    file: "tests/mistakes/files/degrees.urdf", chain: ["base", "tip"], gravity: [0, 0, -9.81],
    functions: [mass_matrix], allow: [odd_angle],
}
