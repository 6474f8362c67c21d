//! Functions that were not asked for, called and needed.

use robot_dynamics::nalgebra::{Matrix1, Vector1, Vector6};
use robot_dynamics::{Kinematics, Simulation, TaylorSimulation, robot_dynamics};

robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [j: revolute { mass: 1, com: [1, 0, 0] }],
    functions: [mass_matrix],
}

robot_dynamics! {
    struct Cart;
    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [rail: prismatic { mass: 2 }],
}

fn tip(_: &impl Kinematics<1>) {}

fn main() {
    let q = Vector1::new(0.3);
    let _: Matrix1<f64> = Arm.mass_matrix(&q);
    let _ = Arm.jacobian(&q);
    let _ = Simulation::new(&Arm);
    tip(&Arm);
    let _ = TaylorSimulation::new(&Arm);
    let _ = Simulation::new(&Cart).tool_wrench(|_, _, _| Vector6::zeros());
}
