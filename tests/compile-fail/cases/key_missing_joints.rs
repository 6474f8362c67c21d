use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm;
    convention: modified,
    gravity: [0, 0, -9.81],
}

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 2>::zeros();
    let _ = Arm.mass_matrix(&q) * Arm.gravity_vector(&q);
    let _ = robot_dynamics::check_against_rnea(&Arm);
}
