use robot_dynamics::robot_dynamics;

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

fn main() {
    let q = robot_dynamics::nalgebra::SVector::<f64, 2>::zeros();
    let _ = (Nested.mass_matrix(&q), Keyword.mass_matrix(&q), Commas.mass_matrix(&q));
    robot_dynamics::check_against_rnea(&Nested).assert_ok();
}
