use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { m, l: f64, d: f64 = 1.0, r }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m, a: l, d: d + r }],
}

fn main() {
    let arm = Arm { m: 1.0, l: 1.0, d: 1.0, r: 1.0 };
    let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
}
