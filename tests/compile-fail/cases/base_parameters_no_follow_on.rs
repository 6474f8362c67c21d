use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { length: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: length, mass: 1, com: [0, 0, ] },
        elbow: revolute { a: lenght, mass: 1 },
    ],
    functions: [regressor, base_parameters],
}

const P: usize = Arm::BASE_PARAMETERS;

fn main() {
    let arm = Arm { length: 0.3 };
    let q = robot_dynamics::nalgebra::Vector2::new(0.1, 0.2);
    let y = arm.regressor(&q, &q, &q);
    let tau = y * arm.base_parameters();
    let beta: robot_dynamics::nalgebra::SVector<f64, P> = arm.base_parameters();
    let _: [&str; P] = Arm::BASE_PARAMETER_NAMES;
    let _ = (tau[0], beta.norm(), y.transpose() * y);
    robot_dynamics::check_against_rnea(&arm).assert_ok();
}
