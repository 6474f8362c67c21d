use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { l: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { mass: 1, limits: [0, l] },
        two: revolute { mass: l },
    ],
    neglect: 1%,
}

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 2>::zeros();
    let _ = Arm { l: 1.0 }.mass_matrix(&q);
}
