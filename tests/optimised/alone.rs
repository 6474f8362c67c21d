//! A program with one generated function, beside which the test looks at the same function among many.

#[path = "three_joints.rs"]
mod three_joints;

use std::hint::black_box;

use robot_dynamics::nalgebra::Vector3;

fn main() {
    black_box(three_joints::gravity_at_three_angles(&black_box(
        Vector3::zeros(),
    )));
}
