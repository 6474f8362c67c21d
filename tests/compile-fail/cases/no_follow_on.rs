//! What a refused table would have is called all the same: no other error follows.

use robot_dynamics::robot_dynamics;

robot_dynamics! {
    #[derive(Clone, Debug)]
    pub struct Arm { length: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: length, mass: 1, com: [0, 0, ] },
        elbow: revolute { a: lenght, mass: 1 },
    ],
}

fn kinetic<const N: usize>(arm: &impl robot_dynamics::Energy<N>) -> f64 {
    let zero = robot_dynamics::nalgebra::SVector::<f64, N>::zeros();
    arm.kinetic_energy(&zero, &zero)
}

fn fall<const N: usize>(_: &impl robot_dynamics::ForwardDynamics<N>) {}

robot_dynamics! {
    pub struct Identified { length: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: length, mass: 1, com: [0, 0, ] },
        elbow: revolute { a: lenght, mass: 1 },
    ],
    functions: [regressor, base_parameters],
}

const P: usize = Identified::BASE_PARAMETERS;

fn main() {
    let arm = Arm { length: 0.3 }.clone();
    let q = robot_dynamics::nalgebra::Vector2::new(0.1, 0.2);
    let _: robot_dynamics::nalgebra::Matrix2<f64> = arm.mass_matrix(&q);
    let _ = arm.coriolis_vector(&q, &q) + arm.gravity_vector(&q) + arm.friction_vector(&q);
    let _ = arm.forward_dynamics(&q, &q, &q).unwrap() + arm.inverse_dynamics(&q, &q, &q);
    let _ = arm.kinetic_energy(&q, &q) + arm.potential_energy(&q) + kinetic(&arm);
    let _ = (arm.table(), Arm::DOF, Arm::JOINT_NAMES[1], Arm::OPERATIONS);
    robot_dynamics::check_against_rnea(&arm).assert_ok();
    fall(&arm);
    identified();
    many(&[arm]);
}

fn many(arms: &[Arm]) {
    use robot_dynamics::Batch;
    let q = [robot_dynamics::nalgebra::Vector2::new(0.1, 0.2)];
    let mut g = q;
    arms[0].gravity_vector_batch(&q, &mut g).unwrap();
    Batch::with_parameters(arms).gravity_vector_batch(&q, &mut g).unwrap();
}

fn identified() {
    let arm = Identified { length: 0.3 };
    let q = robot_dynamics::nalgebra::Vector2::new(0.1, 0.2);
    let y = arm.regressor(&q, &q, &q);
    let tau = y * arm.base_parameters();
    let beta: robot_dynamics::nalgebra::SVector<f64, P> = arm.base_parameters();
    let _: [&str; P] = Identified::BASE_PARAMETER_NAMES;
    let _ = (tau[0], beta.norm(), y.transpose() * y);
    robot_dynamics::check_against_rnea(&arm).assert_ok();
}
