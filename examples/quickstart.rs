//! The first example: a table in, functions out.
//!
//! ```text
//! cargo run --example quickstart
//! ```

use robot_dynamics::{nalgebra::Vector2, robot_dynamics};

robot_dynamics! {
    /// Two slender rods in a vertical plane, angles from the horizontal.
    struct TwoLink { g: f64 }

    convention: standard,
    gravity: [0, -g, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow:    revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
}

fn main() -> Result<(), robot_dynamics::SingularMassMatrix> {
    let arm = TwoLink { g: 9.81 };
    let (q, qd, qdd) = (
        Vector2::new(0.4, 0.9),
        Vector2::new(1.0, -2.0),
        Vector2::new(0.5, 0.3),
    );

    let tau = arm.inverse_dynamics(&q, &qd, &qdd);
    println!("M(q) ={:.4}", arm.mass_matrix(&q));
    println!(
        "V(q, qd) = {:.4?} N m",
        arm.coriolis_vector(&q, &qd).as_slice()
    );
    println!("G(q) = {:.4?} N m", arm.gravity_vector(&q).as_slice());
    println!("tau = {:.4?} N m", tau.as_slice());
    println!(
        "qdd = {:.4?} rad/s^2",
        arm.forward_dynamics(&q, &qd, &tau)?.as_slice()
    );
    println!("{}", robot_dynamics::check_against_rnea(&arm));
    Ok(())
}
