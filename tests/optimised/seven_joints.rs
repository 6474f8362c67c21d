//! A program with functions of one state that take the sines of seven angles, and of six.

use std::hint::black_box;

use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::robot_dynamics;

robot_dynamics! {
    /// A shoulder and a wrist of three axes that meet, and an elbow.
    struct SevenJoints;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        first: revolute { d: 0.36, alpha: -PI/2, mass: 4, com: [0, -0.03, 0.12], inertia: rod(0.3) },
        second: revolute { alpha: PI/2, mass: 4, com: [0, 0.06, 0.04], inertia: rod(0.3) },
        third: revolute { d: 0.42, alpha: PI/2, mass: 3, com: [0, 0.03, 0.13], inertia: rod(0.3) },
        fourth: revolute { alpha: -PI/2, mass: 2.7, com: [0, 0.07, 0.03], inertia: rod(0.2) },
        fifth: revolute { d: 0.4, alpha: -PI/2, mass: 1.7, com: [0, 0.02, 0.08], inertia: rod(0.2) },
        sixth: revolute { alpha: PI/2, mass: 1.8, com: [0, 0, 0.02], inertia: rod(0.1) },
        seventh: revolute { d: 0.126, mass: 0.3, com: [0, 0, 0.02], inertia: rod(0.1) },
    ],
    functions: [mass_matrix, gravity_vector, inverse_dynamics],
}

type Vector = SVector<f64, 7>;

#[inline(never)]
fn torques_of_seven_joints(q: &Vector, qd: &Vector, qdd: &Vector) -> Vector {
    SevenJoints.inverse_dynamics(q, qd, qdd)
}

#[inline(never)]
fn inertia_of_seven_joints(q: &Vector) -> SMatrix<f64, 7, 7> {
    SevenJoints.mass_matrix(q)
}

#[inline(never)]
fn weight_of_seven_joints(q: &Vector) -> Vector {
    SevenJoints.gravity_vector(q)
}

fn main() {
    let [q, qd, qdd] = [1.0, 2.0, 3.0].map(|x| black_box(Vector::repeat(x)));
    black_box(torques_of_seven_joints(&q, &qd, &qdd));
    black_box(inertia_of_seven_joints(&q));
    black_box(weight_of_seven_joints(&q));
}
