robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            mass: 1, inertia: { xx: 1, yy: 1, zz: 1.5, xy: 1.2 }
        },
    ],
}
