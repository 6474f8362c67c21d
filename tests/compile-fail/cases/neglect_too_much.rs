use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
        wrist: revolute { mass: 0, inertia: { zz: 0.01, xx: 0.01, yy: 0.01 }, motor: { inertia: 0.01, gear_ratio: 1 } },
    ],
    neglect: 60%,
}

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 2>::zeros();
    let _ = Arm.mass_matrix(&q);
}
