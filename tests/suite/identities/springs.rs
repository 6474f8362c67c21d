//! Springs.

use robot_dynamics::nalgebra::{SVector, Vector1};

use super::any_arm::AnyArm;
use super::axes::axes;
use super::samples::{Magnitude, assert_small, states};

/// K = stiffness (q - rest), what a follower's spring holds times its factor, and nothing where the table has none.
pub(super) fn springs_are_those_of_the_table<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    let table = robot.table();
    for state in states() {
        let forces = robot.spring_vector(&state.q);
        let magnitude = Magnitude::at(robot, &state).spring;
        let mut expected = SVector::<f64, N>::zeros();
        for axis in axes(&table) {
            let spring = axis.row.spring;
            let stretch = axis.position(&state.q) - spring.rest;
            expected[axis.joint] += axis.factor * spring.stiffness * stretch;
        }
        for (force, expected) in forces.iter().zip(&expected) {
            assert_small(&Vector1::new(force - expected), magnitude, 1);
        }
    }
}

/// K = 0 where every spring is slack.
pub(super) fn nothing_pulls_at_rest<const N: usize, const P: usize>(robot: &dyn AnyArm<N, P>) {
    let table = robot.table();
    let mut rest = SVector::<f64, N>::zeros();
    for axis in axes(&table) {
        let spring = axis.row.spring;
        // Where both a joint and its follower have a spring, both are slack at once.
        if spring.stiffness != 0.0 {
            rest[axis.joint] = (spring.rest - axis.offset) / axis.factor;
        }
    }
    assert_eq!(robot.spring_vector(&rest), SVector::<f64, N>::zeros());
}
