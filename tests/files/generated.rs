//! A file that `robot-dynamics generate --lang rust` wrote is what the macro makes of the same table.

use robot_dynamics::nalgebra::Vector2;
use robot_dynamics::{check_against_rnea, robot_dynamics};

/// Written by the tests of `dynamics-cli`, which keep it as the command writes it.
#[allow(
    unreachable_pub,
    reason = "the module that the file is included in is private"
)]
mod two_rods {
    include!("generated/two_rods.rs");
}
use two_rods::TwoRods;

robot_dynamics! {
    /// Two rods that hang from each other.
    struct Expected;
    convention: modified,
    gravity: [9.81, 0, 0],
    joints: [
        pivot: revolute { mass: 2, com: [0.5, 0, 0] },
        knee: revolute { a: 1, mass: 1, com: [0.25, 0, 0] },
    ],
}

#[test]
fn the_generated_file_is_what_the_macro_expands_to() {
    check_against_rnea(&TwoRods).assert_ok();
    assert_eq!(TwoRods::OPERATIONS, Expected::OPERATIONS);
    assert_eq!(TwoRods.table(), Expected.table());
    let texts = |formulas: &[robot_dynamics::Formula]| {
        formulas
            .iter()
            .map(|formula| formula.text)
            .collect::<Vec<_>>()
    };
    assert_eq!(texts(TwoRods::formulas()), texts(Expected::formulas()));
    let vectors = [[0.3, -1.2], [1.5, 0.7], [-2.0, 4.0]].map(Vector2::from);
    let [q, qd, tau] = &vectors;
    assert_eq!(TwoRods.mass_matrix(q), Expected.mass_matrix(q));
    assert_eq!(
        TwoRods.inverse_dynamics(q, qd, tau),
        Expected.inverse_dynamics(q, qd, tau)
    );
    assert_eq!(
        TwoRods.forward_dynamics(q, qd, tau).expect("accelerations"),
        Expected
            .forward_dynamics(q, qd, tau)
            .expect("accelerations")
    );
}
