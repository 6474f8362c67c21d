use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm(f64, f64);
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
}

fn main() {
    let arm = Arm(1.0, 2.0);
    let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
}
