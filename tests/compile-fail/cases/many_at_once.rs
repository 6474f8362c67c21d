use robot_dynamics::robot_dynamics;

robot_dynamics! {
    /// A call with a mistake in nearly every line.
    pub struct Arm { m1: f64, m2: f32, l: f64, g: f64 }
    convention: modfied,
    gravity: [0, -g],
    let half = l / 0;
    joints: [
        shoulder: revolute { mass: m1, com: [half, 0, 0], alpah: PI/2 },
        elbow: rotary { a: l, mass: m2, com: [half, 0, z], friction: { viscous: -1 } },
        elbow: revolute { a: l mass: -2, inertia: { xx: 1, yy: 1, zz: 3 } },
    ],
    functions: [mass_matrix, inverse_dynamic, mass_matrix],
}

fn main() {
    let arm = Arm { m1: 1.0, m2: 1.0, l: 1.0, g: 9.81 };
    let q = robot_dynamics::nalgebra::Vector3::new(0.1, 0.2, 0.3);
    let tau = arm.inverse_dynamics(&q, &q, &q) + arm.mass_matrix(&q) * q;
    println!("{tau} {:?} {}", Arm::JOINT_NAMES, Arm::DOF);
}
