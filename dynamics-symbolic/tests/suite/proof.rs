//! Every function of every robot is proven, and what vanishes in it is the constant 0.

use crate::derive;
use dynamics_symbolic::{Function, prove};

#[test]
fn all_functions_of_all_robots() {
    for name in arms::NAMES.into_iter().chain([arms::MOUNTED]) {
        let robot = arms::robot(name);
        for function in Function::ALL {
            let program = derive(&robot, function);
            let result = prove::prove(&robot, function, &program);
            assert_eq!(result, Ok(()), "{name} {}", function.name());
            arms::assert_zeros_are_constants(&robot, function, &program);
        }
    }
}
