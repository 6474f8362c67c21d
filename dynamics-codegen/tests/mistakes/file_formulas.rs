robot_dynamics! { struct Formulas; file: "tests/mistakes/files/formulas.toml" }
