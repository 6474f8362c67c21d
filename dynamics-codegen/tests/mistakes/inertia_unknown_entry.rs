robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint: revolute {
            mass: 1, inertia: { Ixx: 0.1, yx: 0.2, ww: 0.3, zz: 0.1, zz: 0.2 }
        },
    ],
}
