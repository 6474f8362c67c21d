robot_dynamics! { struct Arm; file: "tests/mistakes/files/tensor.json" }
robot_dynamics! { struct Named; file: "tests/mistakes/files/joints.json" }
