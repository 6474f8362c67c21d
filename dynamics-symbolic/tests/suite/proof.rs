//! Every function of every robot is proven, and what vanishes in it is the constant 0.

use crate::derive;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, prove};

fn prove_all(is_asked: fn(&Robot) -> bool) {
    let robots = arms::NAMES.into_iter().chain([arms::MOUNTED]);
    for robot in robots.map(arms::robot).filter(is_asked) {
        let name = &robot.name;
        for function in Function::ALL {
            let program = derive(&robot, function);
            let result = prove::prove(&robot, function, &program);
            assert_eq!(result, Ok(()), "{name} {}", function.name());
            arms::assert_zeros_are_constants(&robot, function, &program);
        }
    }
}

#[test]
fn all_functions_of_all_robots() {
    prove_all(|robot| robot.dof() <= 4);
}

/// `cargo test -p dynamics-symbolic --test suite proof:: -- --ignored`
#[test]
#[ignore = "takes half a minute: .ci/run runs it"]
fn all_functions_of_longer_robots() {
    prove_all(|robot| robot.dof() > 4);
}
