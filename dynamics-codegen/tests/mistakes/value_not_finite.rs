robot_dynamics! {
    struct Arm;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { a: NaN, d: inf, alpha: f64::NAN, mass: std::f64::INFINITY, theta: NAN }],
}
