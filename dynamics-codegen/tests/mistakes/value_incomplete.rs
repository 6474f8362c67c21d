robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            a: 1 +,
            alpha: * 2,
            d: (),
            theta: (1, 2),
            mass: 2(3),
            com: [deg, deg(), deg(1, 2)],
        },
    ],
}
