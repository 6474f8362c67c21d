robot_dynamics! { struct Arm; file: "tests/mistakes/files/tensor.json" }
