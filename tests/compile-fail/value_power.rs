use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { l: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: l**2, a: (2 + l)**2 }],
}

fn main() {
    let arm = Arm { l: 1.0 };
    let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
}
