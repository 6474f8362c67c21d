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

/// Written by the same tests from a table with names in its cells.
#[allow(
    unreachable_pub,
    reason = "the module that the file is included in is private"
)]
mod named_rods {
    include!("generated/named_rods.rs");
}
use named_rods::NamedRods;

robot_dynamics! {
    /// Two rods that hang from each other.
    struct Expected;
    convention: modified,
    gravity: [9.81, 0, 0],
    joints: [
        pivot: revolute { mass: 2, com: [0.5, 0, 0] },
        knee: revolute { a: 1, mass: 1, com: [0.25, 0, 0] },
    ],
    functions: [default, taylor_series],
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
    assert_eq!(
        TwoRods.taylor_series(q, qd, tau, 8).expect("a series"),
        Expected.taylor_series(q, qd, tau, 8).expect("a series")
    );
}

robot_dynamics! {
    /// The table of the names.
    struct ExpectedNames { g: f64, l1: f64, m1: f64, l2: f64, m2: f64, load: f64 }
    convention: standard,
    gravity: [0, -g, 0],
    joints: [
        shoulder: revolute { a: l1, mass: m1 },
        elbow: revolute { a: 0.5 * l2, mass: m2 + load },
    ],
    functions: [mass_matrix, gravity_vector],
}

#[test]
fn names_in_a_file_are_fields_as_in_a_call() {
    let (g, l1, m1, l2, m2, load) = (9.81, 0.5, 2.0, 0.8, 1.0, 3.0);
    #[rustfmt::skip]
    let (found, expected) = (
        NamedRods { g, l1, m1, l2, m2, load },
        ExpectedNames { g, l1, m1, l2, m2, load },
    );
    check_against_rnea(&found).assert_ok();
    assert_eq!(found.table(), expected.table());
    let q = Vector2::new(0.3, -1.2);
    assert_eq!(found.mass_matrix(&q), expected.mass_matrix(&q));
    assert_eq!(found.gravity_vector(&q), expected.gravity_vector(&q));
}
