use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { m1: f64 m2: f64, pub m5 f64, m3: f64; m4: }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m1 + m2 + m3 + m4 + m5 }],
}

fn main() {
    let arm = Arm { m1: 1.0, m2: 2.0, m3: 3.0, m4: 4.0, m5: 5.0 };
    let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
}
