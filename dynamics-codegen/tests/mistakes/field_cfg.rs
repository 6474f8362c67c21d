robot_dynamics! {
    pub struct Arm {
        /// Mass, kg.
        #[cfg(windows)]
        m: f64,
    }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m }],
}
