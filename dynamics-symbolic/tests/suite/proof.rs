//! Every function of every robot is proven, and what vanishes in it is the constant 0.

use crate::degrees::bound;
use crate::derive;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, prove};

fn prove_all(is_asked: fn(&Robot) -> bool) {
    let robots = arms::NAMES.into_iter().chain([arms::MOUNTED]);
    for robot in robots.map(arms::robot).filter(is_asked) {
        let name = &robot.name;
        let inverse = derive(&robot, Function::InverseDynamics);
        for function in Function::ALL {
            let program = derive(&robot, function);
            let result = prove::prove(&robot, function, &program);
            assert_eq!(result, Ok(()), "{name} {}", function.name());
            arms::assert_zeros_are_constants(&robot, function, &program);
            let bound = bound(&robot, function, &program, &inverse);
            let documented = documented(if robot.dof() > 7 { "twelve" } else { "seven" });
            assert!(bound <= documented, "{name} {}: {bound}", function.name());
        }
    }
}

/// The smallest probability that the documents give for wrong programs of such arms to pass.
fn documented(joints: &str) -> f64 {
    let documents = ["TRUST.md", "ARCHITECTURE.md", "guide/src/rounding.md"].map(|name| {
        let path = format!("{}/../docs/{name}", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("a document");
        let (before, _) = text
            .split_once(&format!(" for arms of up to {joints} joints"))
            .unwrap_or_else(|| panic!("{name} does not say it"));
        let number = before.split_whitespace().last().expect("a number");
        number.parse().expect("a number")
    });
    documents.into_iter().fold(1.0, f64::min)
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
