robot_dynamics! {
    pub struct Arm;
    convention: standard;
    let m = 1,
    gravity: [0; 0; -9.81],
    joints: [joint: revolute { mass: m; a: 1 }];
}
