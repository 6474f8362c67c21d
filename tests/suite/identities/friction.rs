//! Friction.

use robot_dynamics::nalgebra::{DVector, Vector1};

use super::any_robot::AnyRobot;
use super::axes::axes;
use super::samples::{assert_small, states};

/// F = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)) with C that of the direction, and nothing where
/// the table has none; that of a follower, at its speed, times its factor.
pub(super) fn friction_is_that_of_the_table(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    let table = robot.table();
    for state in states(robot) {
        let friction = robot.friction_vector(&state.qd);
        let mut sums = DVector::<f64>::zeros(n);
        let mut sizes = DVector::<f64>::zeros(n);
        for axis in axes(&table) {
            let (row, qd) = (axis.row, axis.speed(&state.qd));
            let coulomb = row.coulomb[usize::from(qd < 0.0)];
            let beyond = row.stribeck.map_or(0.0, |stribeck| {
                let left = (-(qd / stribeck.velocity).powi(2)).exp();
                (stribeck.friction - coulomb) * left
            });
            let felt = axis.factor * (row.viscous * qd + (coulomb + beyond) * qd.signum());
            sums[axis.freedom] += felt;
            sizes[axis.freedom] += felt.abs();
        }
        for i in 0..n {
            assert_small(&Vector1::new(friction[i] - sums[i]), sizes[i], 1);
        }
    }
}

/// sign(0) = 0, for zeros of either sign.
pub(super) fn nothing_rubs_at_rest(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for zero in [0.0, -0.0] {
        let friction = robot.friction_vector(&DVector::repeat(n, zero));
        assert_eq!(friction, DVector::zeros(n));
    }
}
