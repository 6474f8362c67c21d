//! Derivations: the functions of a robot as expressions on a graph, and from
//! them the shortest program.

pub mod chain;
mod christoffel;
mod composite;
mod derivatives;
mod energy;
pub mod functions;
pub mod gauge;
pub mod inertia;
mod kinematics;
mod momentum;
mod recursive;
mod solve;
mod spatial;
pub mod symbols;
pub mod textbook;

use crate::expr::Graph;
use crate::function::Function;
use crate::program::Program;
use crate::robot::Robot;
use crate::simplify::{Effort, simplify};
use functions::Form;
use gauge::Gauge;
use symbols::Symbols;

/// The program of a function: the shortest that its forms, the gauges and the
/// simplifications lead to.
pub fn derive(robot: &Robot, function: Function) -> Program {
    let forms = Form::of(function, robot.rows.len()).iter().copied();
    if function == Function::ForwardDynamicsDerivatives {
        // Programs so long are compared before they are simplified.
        let gauge = Gauge::search(robot, function, Form::Recursive);
        let form = forms.min_by_key(|&form| gauge.length(robot, function, form));
        let form = form.expect("every function has a form");
        return simplified(robot, function, form, &gauge);
    }
    let programs = forms.map(|form| {
        let gauge = Gauge::search(robot, function, form);
        simplified(robot, function, form, &gauge)
    });
    programs
        .min_by_key(|program| program.operations().total())
        .expect("every function has a form")
}

/// The program of a function in one form and one gauge, shortened.
fn simplified(robot: &Robot, function: Function, form: Form, gauge: &Gauge) -> Program {
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, robot);
    let mut network = gauge.network(&mut symbols, robot, function, form);
    simplify(&mut network, Effort::DEFAULT);
    Program::new(&graph, symbols.meanings(), network.outputs(), &|id| {
        network.definition(id)
    })
}
