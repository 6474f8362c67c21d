//! Springs.

use robot_dynamics::nalgebra::{SVector, Vector1};

use super::any_arm::AnyArm;
use super::samples::{Magnitude, assert_small, states};

/// K = stiffness (q - rest), and nothing where the table has none.
pub(super) fn springs_are_those_of_the_table<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    let table = robot.table();
    for state in states() {
        let forces = robot.spring_vector(&state.q);
        let magnitude = Magnitude::at(robot, &state).spring;
        for (i, row) in table.rows.iter().enumerate() {
            let expected = row.spring.stiffness * (state.q[i] - row.spring.rest);
            assert_small(&Vector1::new(forces[i] - expected), magnitude, 1);
        }
    }
}

/// K = 0 where every spring is slack.
pub(super) fn nothing_pulls_at_rest<const N: usize, const P: usize>(robot: &dyn AnyArm<N, P>) {
    let table = robot.table();
    let rest = SVector::<f64, N>::from_fn(|i, _| table.rows[i].spring.rest);
    assert_eq!(robot.spring_vector(&rest), SVector::<f64, N>::zeros());
}
