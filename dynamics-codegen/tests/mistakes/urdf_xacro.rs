robot_dynamics! { struct Call; file: "tests/mistakes/files/xacro_call.urdf", chain: ["base", "a"], gravity: [0, 0, -9.81] }
robot_dynamics! { struct Inside; file: "tests/mistakes/files/xacro_inside.urdf", chain: ["base", "a"], gravity: [0, 0, -9.81] }
robot_dynamics! { struct Number; file: "tests/mistakes/files/xacro_number.urdf", chain: ["base", "a"], gravity: [0, 0, -9.81] }
robot_dynamics! { struct Prefix; file: "tests/mistakes/files/prefix_broken.urdf", chain: ["base", "a"], gravity: [0, 0, -9.81] }
