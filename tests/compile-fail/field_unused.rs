use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { m1: f64, m2: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m1 }],
}

fn main() {
    let arm = Arm { m1: 1.0, m2: 2.0 };
    let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
}
