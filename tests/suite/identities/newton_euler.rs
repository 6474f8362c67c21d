//! The check that the runtime offers to users.

use robot_dynamics::check::{Check, Evaluate};

/// At the special states and at some random ones: what is wrong is wrong at most of them. The check of the
/// PUMA 560 in `tests/systems` is the one that users call, at all its states.
pub(super) fn every_function_agrees_with_recursive_newton_euler<const N: usize>(
    robot: &impl Evaluate<N>,
) {
    Check::new().samples(8).run(robot).assert_ok();
}
