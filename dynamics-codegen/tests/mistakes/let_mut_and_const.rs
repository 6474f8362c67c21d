robot_dynamics! {
    pub struct Arm;
    let mut x = 3;
    const LENGTH: f64 = 3.0;
    static WIDTH = 2 * 3;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: x, a: LENGTH, d: WIDTH }],
}
