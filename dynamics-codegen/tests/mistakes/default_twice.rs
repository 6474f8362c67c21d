robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
    functions: [default, jacobian, default],
}
