robot_dynamics! {
    pub struct Arm;
    convention: standard
    gravity: [0, 0 -9.81],
    joints: [
        waist: revolute { mass: 1 com: [0 0, 1], inertia: { yy: 0.1 zz: 0.1 } }
        shoulder: revolute { a: 1, mass: 2 3, d: 0.1 }
    ]
    functions: [mass_matrix gravity_vector]
}
