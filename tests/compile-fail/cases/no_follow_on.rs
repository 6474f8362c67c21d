//! A program that calls the methods of a refused table has no other error.

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

robot_dynamics! {
    pub struct Torso;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { mass: 1 },
        left_elbow: revolute { on: waits, mass: 1 },
        right_elbow: revolute { on: waist, mass: 1 },
    ],
    frames: { left_hand: { on: left_elbow, xyz: [0.3, 0, 0] } },
    functions: [jacobian(left_hand), jacobian("right-hand"), grasp = (mass_matrix, forward_kinematics(left_hand))],
}

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
    frames();
    many(&[arm]);
}

fn many(arms: &[Arm]) {
    use robot_dynamics::Batch;
    let q = [robot_dynamics::nalgebra::Vector2::new(0.1, 0.2)];
    let mut g = q;
    arms[0].gravity_vector_batch(&q, &mut g).unwrap();
    Batch::with_parameters(arms).gravity_vector_batch(&q, &mut g).unwrap();
}

fn frames() {
    use robot_dynamics::nalgebra::{Matrix4, Matrix6x3, Vector3};
    let q = Vector3::new(0.1, 0.2, 0.3);
    let _: Matrix6x3<f64> = Torso.jacobian_left_hand(&q) + Torso.jacobian_right_hand(&q);
    let _: Matrix4<f64> = Torso.grasp(&q).1;
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
