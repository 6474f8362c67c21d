use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm<T> { m: T }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m }],
}

fn main() {
    let arm = Arm { m: 1.0 };
    let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
}
