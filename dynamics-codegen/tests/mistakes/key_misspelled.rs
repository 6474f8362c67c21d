robot_dynamics! {
    pub struct Arm { g: f64 }
    Convention: standard,
    gravty: [0, 0, -g],
    joint: [joint: revolute { mass: 1 }],
    function: [mass_matrix],
}
