robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            mass: 1.5f32,
            a: 1e309,
            alpha: 0x10,
            d: "0.3",
            theta: true,
            com: [1e-999999999, 1e999999999, 'x'],
        },
    ],
}
