//! Derivations: the functions of a robot as expressions on a graph, and from
//! them the shortest program.

pub mod chain;
mod christoffel;
mod composite;
mod energy;
pub mod functions;
pub mod inertia;
mod kinematics;
mod recursive;
mod solve;
pub mod symbols;

use crate::expr::Graph;
use crate::function::Function;
use crate::program::Program;
use crate::robot::Robot;
use chain::{Chain, Origin};
use symbols::Symbols;

/// The program of a function.
pub fn derive(robot: &Robot, function: Function) -> Program {
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, robot);
    let mut chain = Chain::new(
        &mut symbols,
        robot,
        &vec![Origin::AfterOffset; robot.rows.len()],
    );
    chain.group_parameters();
    let outputs = functions::outputs(&mut symbols, robot, &chain, function);
    let outputs: Vec<_> = outputs.iter().map(|e| e.edge()).collect();
    Program::new(&graph, symbols.meanings(), &outputs, &|id| {
        graph.operation(id)
    })
}
