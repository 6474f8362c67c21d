use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm;
    convention: standard;
    let m = 1,
    gravity: [0; 0; -9.81],
    joints: [joint: revolute { mass: m; a: 1 }];
}

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 1>::zeros();
    let _ = Arm.mass_matrix(&q);
}
