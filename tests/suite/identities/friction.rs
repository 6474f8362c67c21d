//! Friction.

use robot_dynamics::nalgebra::{SVector, Vector1};

use super::any_arm::AnyArm;
use super::samples::{assert_small, states};

/// F = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)) with C that of the direction, and nothing where
/// the table has none.
pub(super) fn friction_is_that_of_the_table<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    let table = robot.table();
    for state in states() {
        let friction = robot.friction_vector(&state.qd);
        for (i, row) in table.rows.iter().enumerate() {
            let qd = state.qd[i];
            let coulomb = row.coulomb[usize::from(qd < 0.0)];
            let beyond = row.stribeck.map_or(0.0, |stribeck| {
                let left = (-(qd / stribeck.velocity).powi(2)).exp();
                (stribeck.friction - coulomb) * left
            });
            let expected = row.viscous * qd + (coulomb + beyond) * qd.signum();
            assert_small(&Vector1::new(friction[i] - expected), expected.abs(), 1);
        }
    }
}

/// sign(0) = 0, for zeros of either sign.
pub(super) fn nothing_rubs_at_rest<const N: usize, const P: usize>(robot: &dyn AnyArm<N, P>) {
    for zero in [0.0, -0.0] {
        let friction = robot.friction_vector(&SVector::repeat(zero));
        assert_eq!(friction, SVector::<f64, N>::zeros());
    }
}
