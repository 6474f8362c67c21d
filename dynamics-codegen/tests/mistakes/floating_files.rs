robot_dynamics! { struct Bare; file: "tests/mistakes/files/floating.toml" }
robot_dynamics! { struct Cells; file: "tests/mistakes/files/floating_cells.toml" }
robot_dynamics! { struct Words; file: "tests/mistakes/files/floating_words.json" }
robot_dynamics! {
    struct Twice;
    file: "tests/mistakes/files/floating_cells.toml",
    base: floating,
}
robot_dynamics! {
    struct Beside;
    file: "tests/mistakes/files/tree.urdf",
    gravity: [0, 0, -9.81],
    base: floating { mass: 3 },
}
