//! Prints the operation counts of robots, and the time that the engine takes.
#[path = "../tests/support/mod.rs"]
mod support;

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::prove::prove;
use std::time::Instant;

fn main() {
    let only: Vec<String> = std::env::args().skip(1).collect();
    for name in support::NAMES {
        if !only.is_empty() && !only.iter().any(|other| other == name) {
            continue;
        }
        let mut robot = support::robot(name);
        for row in &mut robot.rows {
            row.viscous = dynamics_symbolic::robot::Value::zero();
            row.coulomb = dynamics_symbolic::robot::Value::zero();
        }
        print!("{name:26}");
        for function in Function::default_set(false) {
            let start = Instant::now();
            let program = derive(&robot, function);
            prove(&robot, function, &program).unwrap();
            let operations = program.operations();
            let short: String = function.name().split('_').map(|word| &word[..1]).collect();
            print!(
                " | {short} {} = {} + {} {:.0?}",
                operations.total(),
                operations.multiplications + operations.divisions,
                operations.additions,
                start.elapsed()
            );
        }
        println!();
    }
}
