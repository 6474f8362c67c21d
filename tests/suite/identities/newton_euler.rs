//! The check that the runtime offers to users.

use robot_dynamics::check_against_rnea;
use robots::Arm;

pub(super) fn every_function_agrees_with_recursive_newton_euler<
    const N: usize,
    const P: usize,
    R: Arm<N, P>,
>(
    robot: &R,
) {
    check_against_rnea(robot).assert_ok();
}
