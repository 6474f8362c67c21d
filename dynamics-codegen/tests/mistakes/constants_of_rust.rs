robot_dynamics! {
    pub struct Arm { m1: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { alpha: FRAC_PI_2, theta: TAU, mass: m1 },
        two: revolute { alpha: std::f64::consts::PI, theta: core::f64::consts::FRAC_PI_4, mass: M1 },
        three: revolute { a: LENGTH_2, d: crate::LENGTH, mass: f64::sqrt(2), theta: -PI / 2 },
    ],
}
