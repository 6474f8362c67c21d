//! Every function of every robot is proven, and what vanishes in it is the constant 0.

mod support;
#[path = "support/zeros.rs"]
mod zeros;

use dynamics_symbolic::derive::derive;
use dynamics_symbolic::{Function, prove};

#[test]
fn all_functions_of_all_robots() {
    for name in support::NAMES {
        let robot = support::robot(name);
        for function in Function::ALL {
            let program = derive(&robot, function);
            let result = prove::prove(&robot, function, &program);
            assert_eq!(result, Ok(()), "{name} {}", function.name());
            zeros::assert_zeros_are_constants(&robot, function, &program);
        }
    }
}
