use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { l: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        revolute(j1, a: l),
        revolute(j2, a: l),
        _: revolute { mass: 1 },
    ],
}

fn main() {
    let arm = Arm { l: 1.0 };
    let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 3>::zeros());
}
