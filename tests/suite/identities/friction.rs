//! Friction.

use robot_dynamics::nalgebra::{SVector, Vector1};

use super::any_arm::AnyArm;
use super::axes::axes;
use super::samples::{assert_small, states};

/// F = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)) with C that of the direction, and nothing where
/// the table has none; that of a follower, at its speed, times its factor.
pub(super) fn friction_is_that_of_the_table<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    let table = robot.table();
    for state in states() {
        let friction = robot.friction_vector(&state.qd);
        let mut sums = SVector::<f64, N>::zeros();
        let mut sizes = SVector::<f64, N>::zeros();
        for axis in axes(&table) {
            let (row, qd) = (axis.row, axis.speed(&state.qd));
            let coulomb = row.coulomb[usize::from(qd < 0.0)];
            let beyond = row.stribeck.map_or(0.0, |stribeck| {
                let left = (-(qd / stribeck.velocity).powi(2)).exp();
                (stribeck.friction - coulomb) * left
            });
            let felt = axis.factor * (row.viscous * qd + (coulomb + beyond) * qd.signum());
            sums[axis.joint] += felt;
            sizes[axis.joint] += felt.abs();
        }
        for i in 0..N {
            assert_small(&Vector1::new(friction[i] - sums[i]), sizes[i], 1);
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
