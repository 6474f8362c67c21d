robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            mass: 1,
            inertia: { ixx: 1, Iyx: 0, I_zz: 1 },
            motor: { inertia: 1, gear: 50 },
        },
    ],
    functions: [gravity, coriolis, mass_matrix],
}
