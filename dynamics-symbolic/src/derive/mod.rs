//! Derivations: the functions of a robot as expressions on a graph, and from
//! them the shortest program.

pub mod chain;
mod christoffel;
mod composite;
mod energy;
pub mod functions;
pub mod gauge;
pub mod inertia;
mod kinematics;
mod recursive;
mod solve;
pub mod symbols;
pub mod textbook;

use crate::expr::Graph;
use crate::function::Function;
use crate::program::Program;
use crate::robot::Robot;
use crate::simplify::{Effort, Network, simplify};
use functions::Form;
use gauge::Gauge;
use symbols::Symbols;

/// The program of a function: the shortest that its forms, the gauges and the
/// simplifications lead to.
pub fn derive(robot: &Robot, function: Function) -> Program {
    let forms = Form::of(function, robot.rows.len());
    let programs = forms.iter().map(|&form| derive_form(robot, function, form));
    programs
        .min_by_key(|program| program.operations().total())
        .expect("every function has a form")
}

fn derive_form(robot: &Robot, function: Function, form: Form) -> Program {
    let gauge = Gauge::search(robot, function, form);
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, robot);
    let chain = gauge.chain(&mut symbols, robot);
    let outputs = functions::outputs(&mut symbols, robot, &chain, function, form);
    let outputs: Vec<_> = outputs.iter().map(|e| e.edge()).collect();
    let mut network = Network::new(&graph, &outputs);
    simplify(&mut network, Effort::DEFAULT);
    Program::new(&graph, symbols.meanings(), &outputs, &|id| {
        network.definition(id)
    })
}
