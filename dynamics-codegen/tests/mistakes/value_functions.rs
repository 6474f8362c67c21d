robot_dynamics! {
    pub struct Arm { m: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { a: sqrt(-1), d: sqrt(m), mass: sqrt(PI) },
        two: revolute { a: sqrt(), d: tan(1), mass: m * sin(1.5708) },
        three: revolute { a: sin(30), d: cos(deg(PI/3)), mass: 1 / (sin(PI/6) - 1/2) },
        four: revolute { a: 1 / (sin(m) - sin(m)), d: 1 / (sqrt(6) - sqrt(2) * sqrt(3)), mass: sqrt(sqrt(2)) },
        five: revolute { alpha: degrees(90), a: sqrt, mass: f64::sin(1), d: 2.sqrt() },
    ],
}
