use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        one: revolute { mass: 1, limits: [PI] },
        two: revolute { mass: 1, limits: PI },
    ],
}

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 2>::zeros();
    let _ = Arm.mass_matrix(&q);
}
