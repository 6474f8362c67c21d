use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
    ],
    functions: [regressor],
    tests: true,
}

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 1>::zeros();
    let _ = Arm.regressor(&q, &q, &q);
}
