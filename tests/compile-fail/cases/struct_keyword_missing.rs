use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
}

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 1>::zeros();
    let _ = Arm.mass_matrix(&q);
}
