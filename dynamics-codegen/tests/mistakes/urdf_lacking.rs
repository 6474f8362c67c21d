robot_dynamics! { struct Lacking; file: "tests/mistakes/files/lacking.urdf", gravity: [0, 0, -9.81] }
// A tensor of zeros is one: the negative friction is the only mistake.
robot_dynamics! { struct Points; file: "tests/mistakes/files/points.urdf", gravity: [0, 0, -9.81] }
