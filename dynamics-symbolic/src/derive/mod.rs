//! Derivations: the functions of a robot as expressions on a graph, and from
//! them the shortest program.

mod articulated;
pub mod base;
pub mod chain;
mod christoffel;
mod composite;
mod derivatives;
mod energy;
pub mod functions;
pub mod gauge;
pub mod inertia;
mod joints;
mod kinematics;
mod momentum;
mod recursive;
mod regressor;
mod solve;
mod spatial;
pub mod symbols;
pub mod textbook;

use crate::expr::Graph;
use crate::function::{Form, Function, Search, Trial};
use crate::program::Program;
use crate::robot::Robot;
use crate::simplify::{Effort, simplify};
use gauge::Gauge;
use symbols::Symbols;

/// The program of a function: the shortest that its forms, the gauges and the
/// simplifications lead to.
pub fn derive(robot: &Robot, function: Function) -> Program {
    let forms = promising_forms(robot, function);
    if is_tried_by(Trial::Unsimplified, function) {
        let gauge = Gauge::search(robot, function, Form::Recursive);
        let length = |form: &Form| gauge.length(robot, function, *form);
        let form = forms.into_iter().min_by_key(length);
        let form = form.expect("every function has a form");
        return simplified(robot, function, form, &gauge);
    }
    let programs = forms
        .into_iter()
        .map(|form| derive_form(robot, function, form));
    programs
        .min_by_key(|program| program.operations().total())
        .expect("every function has a form")
}

fn is_tried_by(trial: Trial, function: Function) -> bool {
    let second = function.row().second;
    second.is_some_and(|second| second.trial == trial)
}

/// The forms that are tried. Where they differ by the number of joints, how they compare shows
/// before any search: a form that takes over a tenth more than another in the plain gauge is
/// not tried.
fn promising_forms(robot: &Robot, function: Function) -> Vec<Form> {
    let forms = function.forms(robot.dof());
    if !is_tried_by(Trial::Promising, function) {
        return forms;
    }
    let plain = Gauge::plain(robot.rows.len());
    let cost = |form| plain.length(robot, function, form);
    let costs: Vec<_> = forms.iter().map(|&form| cost(form)).collect();
    let least = costs.iter().copied().min().unwrap_or(0);
    let forms = forms.iter().zip(costs);
    let promising = forms.filter(|(_, cost)| 10 * cost <= 11 * least);
    promising.map(|(&form, _)| form).collect()
}

/// The program of a function written in one form: the shortest that the gauges and the
/// simplifications lead to.
pub fn derive_form(robot: &Robot, function: Function, form: Form) -> Program {
    let gauge = Gauge::search(robot, function, form);
    simplified(robot, function, form, &gauge)
}

/// The program of a function in one form and one gauge, shortened.
fn simplified(robot: &Robot, function: Function, form: Form, gauge: &Gauge) -> Program {
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, robot);
    let mut network = gauge.network(&mut symbols, robot, function, form);
    // Another way to write a number may be a difference of larger ones.
    if function.row().search != Search::Accuracy {
        simplify(&mut network, Effort::DEFAULT);
    }
    let program = Program::new(&graph, symbols.meanings(), network.outputs(), &|id| {
        network.definition(id)
    });
    program.balanced()
}
