//! Integers in place of decimals, and a law with a memory where none may have one.

use robot_dynamics::nalgebra::{Vector1, Vector2};
use robot_dynamics::{Simulation, robot_dynamics};

robot_dynamics! {
    struct Arm;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        one: revolute { a: 1, mass: 1, com: [1, 0, 0] },
        two: revolute { a: 1, mass: 1, com: [1, 0, 0] },
    ],
}

robot_dynamics! {
    struct Cart;
    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [rail: prismatic { mass: 2 }],
}

fn main() {
    with_a_memory();
    let q = Vector2::new(1, 2);
    let _ = Arm.mass_matrix(&q);
    let _ = Arm.coriolis_vector(&Vector2::new(1, 2), &Vector2::new(0, 1));
}

fn with_a_memory() {
    let mut integral = Vector1::zeros();
    let law = move |_: f64, q: &Vector1<f64>, qd: &Vector1<f64>| {
        integral += q;
        -integral - qd
    };
    let _ = Simulation::new(&Cart).torque(law);
}
