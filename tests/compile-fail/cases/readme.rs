//! The mistake that the README shows.
use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct TwoLink;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, alpha: 90, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
}

fn main() {}
