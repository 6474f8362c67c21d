robot_dynamics! { struct Missing; file: "tests/mistakes/files/nothing.toml", gravity: [0, 0, -9.81] }
robot_dynamics! { struct OtherFormat; file: "tests/mistakes/files/arm.yaml" }
robot_dynamics! { struct NoFormat; file: "tests/mistakes/files" }
robot_dynamics! { struct Folder; file: "tests/mistakes/files/../files/.toml" }
robot_dynamics! { struct OtherBytes; file: "tests/mistakes/files/latin.toml" }
robot_dynamics! { struct NoToml; file: "tests/mistakes/files/syntax.toml" }
robot_dynamics! { struct SingleBrackets; file: "tests/mistakes/files/single_brackets.toml" }
robot_dynamics! { struct NoJson; file: "tests/mistakes/files/syntax.json" }
robot_dynamics! { struct NoText; file: arm.toml }
