robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            #[cfg(feature = "heavy")]
            mass: 1,
            /// The link's length, m.
            a: 1,
        },
    ],
}
