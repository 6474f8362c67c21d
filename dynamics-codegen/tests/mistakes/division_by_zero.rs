robot_dynamics! {
    pub struct Arm { m: f64 }
    let zero = 0.3 - 3 / 10;
    convention: standard,
    gravity: [0, 0, -9.81 / 0],
    joints: [joint: revolute { mass: m, a: 1 / zero, d: 1 / (m - m), alpha: 1 / (PI/2 - deg(90)) }],
}
