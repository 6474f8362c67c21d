//! Operations of the functions of robots with branches, and how long their search takes:
//! `cargo run --release -p dynamics-symbolic --example tree_counts [ROBOT [FUNCTION]]`

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::robot::Robot;
use measuring::table::Table;

const FUNCTIONS: [Function; 6] = [
    Function::InverseDynamics,
    Function::MassMatrix,
    Function::ForwardDynamics,
    Function::GravityVector,
    Function::CoriolisVector,
    Function::InverseDynamicsDerivatives,
];

fn main() {
    let mut arguments = std::env::args().skip(1);
    let only = arguments.next();
    let function = arguments.next().map(|name| {
        let function = Function::from_name(&name);
        function.expect("the name of a function")
    });
    let heads = ["robot", "function", "mul", "add", "div", "total", "time, s"];
    let mut table = Table::new("Robots with branches", &heads);
    let robots = arms::TREES.map(arms::tree).into_iter();
    let serial = ["panda", "generic_chain_n7", "ur5"].map(arms::robot);
    let floating = arms::FLOATING.map(|name| Robot {
        name: format!("{name}, floating"),
        ..arms::floating(name)
    });
    for robot in robots.chain(serial).chain(floating) {
        if only.as_ref().is_some_and(|only| *only != robot.name) {
            continue;
        }
        for each in FUNCTIONS {
            if function.is_some_and(|function| function != each) {
                continue;
            }
            let start = measuring::thread_seconds();
            let program = derive(&robot, each);
            let time = measuring::thread_seconds() - start;
            let count = program.operations();
            let numbers = [
                count.multiplications,
                count.additions,
                count.divisions,
                count.total(),
            ];
            let [mul, add, div, total] = numbers.map(|x| x.to_string());
            let plain = if program.is_plain { " (plain)" } else { "" };
            table.row([
                robot.name.clone(),
                format!("{}{plain}", each.name()),
                mul,
                add,
                div,
                total,
                format!("{time:.2}"),
            ]);
        }
    }
    print!("{}", table.text());
}
