use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
        elbow: revolute { a: 0.5, mass: 1, limits: [-2, 2] },
    ],
    lock: [elbow = 0.3, shoulder = 0],
}

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 1>::zeros();
    let _ = Arm.mass_matrix(&q);
}
