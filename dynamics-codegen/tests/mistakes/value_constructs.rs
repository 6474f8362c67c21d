robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            a: 2.0_f64.sqrt(),
            alpha: std::f64::consts::PI / 2,
            d: if true { 1 } else { 2 },
            theta: sin(1),
            mass: 2^3,
            com: [lengths[0], 1 < 2, { 1 }],
            inertia: { xx: 1 as f64, yy: 7 % 2, zz: f64::MAX },
        },
    ],
}
