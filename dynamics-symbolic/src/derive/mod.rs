//! Derivations: the functions of a robot as expressions on a graph, and from
//! them the shortest program.

mod accuracy;
mod articulated;
pub mod base;
pub mod chain;
mod christoffel;
mod composite;
mod derivatives;
mod energy;
pub mod functions;
pub mod gauge;
mod joint_forces;
mod joints;
mod kinematics;
mod momentum;
pub(crate) mod place;
mod recursive;
mod regressor;
mod rows;
mod solve;
mod states;
pub mod symbols;
pub mod textbook;
pub mod units;

use crate::expr::Graph;
use crate::function::{Form, Function, Search, Trial};
use crate::program::Program;
use crate::robot::Robot;
use crate::simplify::{Effort, simplify};
use accuracy::Recursion;
use gauge::Gauge;
use symbols::Symbols;

/// The program of a function: the shortest that its forms, the gauges and the
/// simplifications lead to, as far as they keep its digits.
pub fn derive(robot: &Robot, function: Function) -> Program {
    let forms = promising_forms(robot, function);
    if is_tried_by(Trial::Unsimplified, function) {
        let gauge = Gauge::search(robot, function, Form::Recursive);
        let length = |form: &Form| gauge.length(robot, function, *form);
        let form = forms.into_iter().min_by_key(length);
        let form = form.expect("every function has a form");
        return accurate(robot, function, form, gauge);
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
/// simplifications lead to, as far as they keep its digits.
pub fn derive_form(robot: &Robot, function: Function, form: Form) -> Program {
    accurate(robot, function, form, Gauge::search(robot, function, form))
}

/// The program of a function in one form and one gauge, shortened. Where that costs digits the gauge
/// is the plain one, and where that is not enough nothing is simplified.
fn accurate(robot: &Robot, function: Function, form: Form, gauge: Gauge) -> Program {
    if function.row().search == Search::Accuracy {
        // Another way to write a number may be a difference of larger ones.
        return unsimplified(robot, function, form, &gauge).balanced();
    }
    let recursion = Recursion::of(robot, function, form);
    let gauges = [gauge, Gauge::plain(robot.rows.len())];
    let mut programs = gauges
        .iter()
        .map(|gauge| simplified(robot, function, form, gauge, &recursion));
    let accurate = programs.find(|program| recursion.accepts(robot, program));
    accurate.unwrap_or_else(|| recursion.into_program())
}

/// The program of a function in the plain gauge, as its recursion is written: long, and accurate. It
/// is what the rounding of programs is measured by, and what is put out where every shorter one costs
/// digits.
pub fn derive_plain(robot: &Robot, function: Function) -> Program {
    let gauge = match function.row().search {
        // Written so in any case: its recursion is its own.
        Search::Accuracy => Gauge::physical(robot.rows.len()),
        _ => Gauge::plain(robot.rows.len()),
    };
    unsimplified(robot, function, Form::Recursive, &gauge)
}

/// The program of a function in one form and one gauge, as the derivation writes it.
fn unsimplified(robot: &Robot, function: Function, form: Form, gauge: &Gauge) -> Program {
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, robot);
    let network = gauge.network(&mut symbols, robot, function, form);
    network.program(symbols.meanings())
}

/// The program of a function in one form and one gauge, shortened.
fn simplified(
    robot: &Robot,
    function: Function,
    form: Form,
    gauge: &Gauge,
    recursion: &Recursion,
) -> Program {
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, robot);
    let mut network = gauge.network(&mut symbols, robot, function, form);
    let mut judge = recursion.judge(robot, &symbols, &network);
    simplify(&mut network, &mut judge, Effort::DEFAULT);
    network.program(symbols.meanings()).balanced()
}
