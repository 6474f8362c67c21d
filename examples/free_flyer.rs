//! A free-flying arm turns itself by moving its joints: a cat in a fall.
//!
//! Its momentum is zero and stays so, whatever the joints do. A closed path of the joints leaves the base turned all the same.
//!
//! `cargo run --release --example free_flyer`

use robot_dynamics::nalgebra::{SVector, Vector2};
use robot_dynamics::simulation::Dop853;
use robot_dynamics::{Pose, Simulation, robot_dynamics};

robot_dynamics! {
    /// A body of 10 kg with an arm of two joints in its plane.
    struct Cat;

    convention: modified,
    gravity: [0, 0, 0],
    base: floating { mass: 10, inertia: sphere(0.3) },
    joints: [
        shoulder: revolute { on: base, at: { xyz: [0.3, 0, 0], rpy: [0, 0, 0] }, mass: 2, com: [0.25, 0, 0], inertia: rod(0.5) },
        elbow:    revolute { a: 0.5, mass: 2, com: [0.25, 0, 0], inertia: rod(0.5) },
    ],
    functions: [default, generalized_momentum],
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // The joints go once around a circle, slowly at both ends.
    let turn = core::f64::consts::TAU;
    let path = |t: f64| {
        let angle = turn * t.min(1.0);
        let angle = angle - angle.sin();
        Vector2::new(1.0 - angle.cos(), angle.sin())
    };
    let motion = Simulation::new(&Cat)
        .initial(Pose::identity(), SVector::zeros(), SVector::zeros())
        .torque(|t, _base, q, v| {
            let error = path(t) - q;
            let [shoulder, elbow] = [0, 1].map(|i| 4000.0 * error[i] - 100.0 * v[6 + i]);
            SVector::from([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, shoulder, elbow])
        })
        .method(Dop853::with_tolerance(1e-12))
        .duration(1.5)
        .run()?;

    let momenta = motion
        .samples()
        .map(|at| Cat.generalized_momentum(&at.q, &at.qd));
    let largest = momenta
        .map(|momentum| momentum.fixed_rows::<6>(0).amax())
        .fold(0.0, f64::max);
    println!("the momentum of the whole stays below {largest:.1e}");
    let end = motion.last().ok_or("no sample")?;
    let angle = end
        .base
        .rotation
        .m21
        .atan2(end.base.rotation.m11)
        .to_degrees();
    println!("after one circle of the joints the body has turned by {angle:.2} degrees");
    println!(
        "the joints are {:.3} rad from where they began",
        end.q.amax()
    );
    assert!(largest < 1e-9 && angle.abs() > 1.0 && end.q.amax() < 0.01);
    Ok(())
}
