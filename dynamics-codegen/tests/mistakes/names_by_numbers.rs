robot_dynamics! { struct Numbers; file: "tests/mistakes/files/numbers.toml" }
robot_dynamics! {
    struct Couple;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { mass: 1, com: [1, 0, 0] }, two: revolute { mass: 1, com: [1, 0, 0] }],
    couple: [2 = one],
}
