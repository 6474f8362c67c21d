robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            mass: 4.8, inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 }
        },
    ],
}
