robot_dynamics! { struct Named; file: "tests/mistakes/files/names_a_file.toml" }
