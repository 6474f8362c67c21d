use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        elbow: revolute { mass: 1 },
        elbow: revolute { a: 1, mass: 1 },
    ],
}

fn main() {
    let _ = Arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 2>::zeros());
}
