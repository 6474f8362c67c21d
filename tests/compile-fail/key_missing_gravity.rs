use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm;
    convention: modified,
    joints: [joint: revolute { mass: 1 }],
}

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 1>::zeros();
    let _ = Arm.mass_matrix(&q);
}
