robot_dynamics! {
    struct Words { l2: f64 }
    file: "tests/mistakes/files/words.toml",
}
