//! Joints that are missing, unreadable or all locked, and a share that leaves too little of the arm.

use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Jointless;
    convention: modified,
    gravity: [0, 0, -9.81],
}

robot_dynamics! {
    pub struct Nested;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [[one: revolute { mass: 1 }, two: revolute { a: 1, mass: 1 }]],
}

robot_dynamics! {
    pub struct Keyword;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint one: revolute { mass: 1 }, joint two: revolute { a: 1, mass: 1 }],
}

robot_dynamics! {
    pub struct Commas;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [one: revolute { mass: 1 } two = revolute { a: 1, mass: 1 }],
}

robot_dynamics! {
    pub struct Locked;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
        elbow: revolute { a: 0.5, mass: 1, limits: [-2, 2] },
    ],
    lock: [elbow = 0.3, shoulder = 0],
}

robot_dynamics! {
    pub struct Neglected;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 0.5, mass: 1 },
        wrist: revolute { mass: 0, inertia: { zz: 0.01, xx: 0.01, yy: 0.01 }, motor: { inertia: 0.01, gear_ratio: 1 } },
    ],
    neglect: 60%,
}

fn main() {
    {
        let q = robot_dynamics::nalgebra::SVector::<f64, 2>::zeros();
        let _ = Jointless.mass_matrix(&q) * Jointless.gravity_vector(&q);
        let _ = robot_dynamics::check_against_rnea(&Jointless);
    }
    {
        let q = robot_dynamics::nalgebra::SVector::<f64, 2>::zeros();
        let _ = (Nested.mass_matrix(&q), Keyword.mass_matrix(&q), Commas.mass_matrix(&q));
        robot_dynamics::check_against_rnea(&Nested).assert_ok();
    }
    {
        let q = robot_dynamics::nalgebra::SVector::<f64, 1>::zeros();
        let _ = Locked.mass_matrix(&q);
    }
    {
        let q = robot_dynamics::nalgebra::SVector::<f64, 2>::zeros();
        let _ = Neglected.mass_matrix(&q);
    }
}
