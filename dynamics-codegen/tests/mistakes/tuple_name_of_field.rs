robot_dynamics! {
    pub struct Arm { load: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: load }],
    functions: [load = (mass_matrix, gravity_vector)],
}
