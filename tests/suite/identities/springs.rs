//! Springs.

use robot_dynamics::nalgebra::{DVector, Vector1};

use super::any_robot::AnyRobot;
use super::axes::axes;
use super::samples::{Magnitude, assert_small, states};

/// K = stiffness (q - rest), what a follower's spring holds times its factor, and nothing where the table has none.
pub(super) fn springs_are_those_of_the_table(robot: &dyn AnyRobot) {
    let table = robot.table();
    for state in states(robot) {
        let forces = robot.spring_vector(&state.q);
        let magnitude = Magnitude::at(robot, &state).spring;
        let mut expected = DVector::<f64>::zeros(robot.freedoms());
        for axis in axes(&table) {
            let spring = axis.row.spring;
            let stretch = axis.position(&state.q.q) - spring.rest;
            expected[axis.freedom] += axis.factor * spring.stiffness * stretch;
        }
        for (force, expected) in forces.iter().zip(&expected) {
            assert_small(&Vector1::new(force - expected), magnitude, 1);
        }
    }
}

/// K = 0 where every spring is slack.
pub(super) fn nothing_pulls_at_rest(robot: &dyn AnyRobot) {
    let table = robot.table();
    let mut rest = states(robot).next().expect("a state").q;
    for axis in axes(&table) {
        let spring = axis.row.spring;
        // Where both a joint and its follower have a spring, both are slack at once.
        if spring.stiffness != 0.0 {
            rest.q[axis.joint] = (spring.rest - axis.offset) / axis.factor;
        }
    }
    assert_eq!(robot.spring_vector(&rest), DVector::zeros(robot.freedoms()));
}
