//! A free-flying arm turns itself by moving its joints: a cat in a fall.
//!
//! Its momentum is zero and stays so, whatever the joints do. With the rows of the base of M u = 0 the velocity of the base
//! follows from those of the joints, and a closed path of the joints leaves the base turned.
//!
//! `cargo run --release --example free_flyer`

use robot_dynamics::nalgebra::{Matrix6, Rotation3, SVector, Vector2, Vector3, Vector6};
use robot_dynamics::{Pose, robot_dynamics};

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

/// The velocity of the base at which the whole robot has no momentum.
fn velocity_of_base(q: &Vector2<f64>, qd: &Vector2<f64>) -> Vector6<f64> {
    let mass_matrix = Cat.mass_matrix(q);
    let of_base: Matrix6<f64> = mass_matrix.fixed_view::<6, 6>(0, 0).into_owned();
    let of_joints = mass_matrix.fixed_view::<6, 2>(0, 6) * qd;
    -of_base.cholesky().expect("M is definite").solve(&of_joints)
}

fn main() {
    // The joints go once around a circle.
    let path = |t: f64| {
        let (s, c) = t.sin_cos();
        (Vector2::new(1.0 - c, s), Vector2::new(s, c))
    };
    let steps = 2000;
    let h = core::f64::consts::TAU / f64::from(steps);
    let mut pose = Pose::<f64>::identity();
    let mut largest: f64 = 0.0;
    for step in 0..steps {
        // The exponential of the velocity in the middle of the step.
        let (q, qd) = path((f64::from(step) + 0.5) * h);
        let of_base = velocity_of_base(&q, &qd);
        let u = SVector::<f64, 8>::from_fn(|i, _| if i < 6 { of_base[i] } else { qd[i - 6] });
        let momentum = Cat.generalized_momentum(&q, &u);
        largest = largest.max(momentum.fixed_rows::<6>(0).amax());
        let [v, w] = [0, 3].map(|first| Vector3::from(of_base.fixed_rows::<3>(first)));
        let half = Rotation3::new(w * (0.5 * h)).into_inner();
        pose.position += pose.rotation * half * v * h;
        pose.rotation *= Rotation3::new(w * h).into_inner();
    }
    let angle = pose.rotation.m21.atan2(pose.rotation.m11).to_degrees();
    println!("momentum stays below {largest:.1e}");
    println!("after one circle of the joints the body has turned by {angle:.2} degrees");
    assert!(largest < 1e-12 && angle.abs() > 1.0);
}
