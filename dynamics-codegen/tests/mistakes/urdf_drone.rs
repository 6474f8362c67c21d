// A drone has no joint that moves: its base does.
robot_dynamics! { struct Fixed; file: "tests/mistakes/files/drone.urdf", gravity: [0, 0, -9.81] }
robot_dynamics! {
    struct Flying;
    file: "tests/mistakes/files/drone.urdf", gravity: [0, 0, -9.81], base: floating, functions: [default, jacobian(rotor)],
}
