//! The range of a joint.

use robot_dynamics::robot_dynamics;

robot_dynamics! {
    struct Ranges;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        turn: revolute { mass: 1, com: [0.1, 0, 0], limits: [-PI, deg(90)] },
        slide: prismatic { alpha: PI/2, mass: 2, limits: [0.1, 0.35] },
        free: revolute { mass: 1, com: [0.1, 0, 0] },
        wound: revolute { mass: 1, com: [0.1, 0, 0], limits: [-100 * PI, 100 * PI] },
    ],
    functions: [gravity_vector],
}

#[test]
fn the_table_has_the_limits() {
    use std::f64::consts::{FRAC_PI_2, PI};
    let limits = Ranges.table().rows.map(|row| row.limits);
    assert_eq!(limits[0], Some([-PI, FRAC_PI_2]));
    assert_eq!(limits[1], Some([0.1, 0.35]));
    assert_eq!(limits[2], None);
    assert_eq!(limits[3], Some([-100.0 * PI, 100.0 * PI]));
}
