robot_dynamics! { struct Words; file: "tests/mistakes/files/words.urdf", chain: ["base", "a"], gravity: [0, 0, -9.81] }
robot_dynamics! { struct Names; file: "tests/mistakes/files/names.urdf", chain: ["base", "a"], gravity: [0, 0, -9.81] }
robot_dynamics! { struct Broken; file: "tests/mistakes/files/broken.urdf", chain: ["base", "a"], gravity: [0, 0, -9.81] }
robot_dynamics! { struct Other; file: "tests/mistakes/files/other.urdf", chain: ["base", "a"], gravity: [0, 0, -9.81] }
robot_dynamics! { struct Xacro; file: "tests/mistakes/files/xacro.urdf", chain: ["base", "a"], gravity: [0, 0, -9.81] }
