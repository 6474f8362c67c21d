//! Derivations: the functions of a robot as expressions on a graph, and from
//! them the shortest program.

mod accuracy;
mod articulated;
pub mod base;
pub mod center_of_mass;
mod centroidal;
pub mod chain;
mod christoffel;
mod composite;
mod derivatives;
mod displacement;
mod energy;
pub mod functions;
mod fused;
pub mod gauge;
mod joint_forces;
mod joints;
mod kinematics;
mod link_jacobians;
mod momenta;
mod momentum;
mod passivity;
pub(crate) mod place;
mod rates;
mod recursive;
mod regressor;
pub(crate) mod rows;
mod second_derivatives;
mod solve;
pub(crate) mod states;
pub mod symbols;
#[cfg(test)]
mod tests;
pub mod textbook;
mod tip;
pub mod units;

use crate::expr::{Edge, Graph};
use crate::function::{self, Form, Function, Search, Trial};
use crate::mechanism::Mechanism;
use crate::program::Program;
use crate::robot::Robot;
use crate::simplify::{Effort, Network, simplify, simplify_apart};
use accuracy::Recursion;
use functions::Part;
use gauge::Gauge;
use symbols::Symbols;

/// The program of a function: the shortest that its forms, the gauges and the
/// simplifications lead to, as far as they keep its digits.
pub fn derive(robot: &Robot, part: impl Into<function::Part>) -> Program {
    shortest(&robot.into(), part.into())
}

fn shortest(arm: &Mechanism, part: function::Part) -> Program {
    let parts = promising_forms(arm, part);
    if is_tried_by(Trial::Unsimplified, part.function) {
        let gauge = Gauge::search(arm, &[Part::recursive(part)]);
        let length = |part: &Part| gauge.length(arm, &[*part]);
        let part = parts.into_iter().min_by_key(length);
        let part = part.expect("every function has a form");
        return accurate(arm, &[Written::new(&[part], gauge)]);
    }
    let programs = parts.into_iter().map(|part| derive_part(arm, part));
    programs
        .min_by_key(|program| program.operations().total())
        .expect("every function has a form")
}

/// The program of several functions, whose outputs follow one another, or of one.
pub fn derive_together(robot: &Robot, parts: &[function::Part]) -> Program {
    let arm = robot.into();
    match parts {
        [part] => shortest(&arm, *part),
        _ => fused::derive(&arm, parts),
    }
}

fn is_tried_by(trial: Trial, function: Function) -> bool {
    let second = function.row().second;
    second.is_some_and(|second| second.trial == trial)
}

/// The forms that are tried. Where they differ by the number of joints, how they compare shows
/// before any search: a form that takes over a tenth more than another in the plain gauge is
/// not tried.
fn promising_forms(arm: &Mechanism, part: function::Part) -> Vec<Part> {
    let forms = forms(arm, part.function).into_iter();
    let parts: Vec<_> = forms.map(|form| Part::new(part, form)).collect();
    if !is_tried_by(Trial::Promising, part.function) {
        return parts;
    }
    let plain = Gauge::plain(arm.joints.len());
    let cost = |part: &Part| plain.length(arm, &[*part]);
    let costs: Vec<_> = parts.iter().map(cost).collect();
    let least = costs.iter().copied().min().unwrap_or(0);
    let parts = parts.into_iter().zip(costs);
    let promising = parts.filter(|(_, cost)| 10 * cost <= 11 * least);
    promising.map(|(part, _)| part).collect()
}

/// The forms that may be the shortest. Articulated bodies are of joints that move by themselves.
fn forms(arm: &Mechanism, function: Function) -> Vec<Form> {
    let mut forms = function.forms(arm.most_in_line());
    forms.retain(|form| *form != Form::Articulated || !arm.is_coupled());
    forms
}

/// The program of a function written in one form: the shortest that the gauges and the
/// simplifications lead to, as far as they keep its digits.
pub fn derive_form(robot: &Robot, function: Function, form: Form) -> Program {
    derive_part(&robot.into(), Part::new(function, form))
}

fn derive_part(arm: &Mechanism, part: Part) -> Program {
    let gauge = Gauge::search(arm, &[part]);
    accurate(arm, &[Written::new(&[part], gauge)])
}

/// Functions that are written in one gauge.
struct Written {
    parts: Vec<Part>,
    gauge: Gauge,
}

impl Written {
    fn new(parts: &[Part], gauge: Gauge) -> Self {
        Written {
            parts: parts.to_vec(),
            gauge,
        }
    }
}

/// The program of what is written, shortened. Where that costs digits the gauge
/// is the plain one, and where that is not enough nothing is simplified.
fn accurate(arm: &Mechanism, written: &[Written]) -> Program {
    let parts: Vec<_> = written.iter().flat_map(|w| w.parts.clone()).collect();
    if let [part] = parts[..]
        && part.function.row().search == Search::Accuracy
    {
        // Another way to write a number may be a difference of larger ones.
        return unsimplified(arm, written).balanced();
    }
    let recursion = Recursion::of(arm, &parts);
    let plain = [Written::new(&parts, Gauge::plain(arm.joints.len()))];
    let mut programs = [written, &plain]
        .into_iter()
        .map(|written| simplified(arm, written, &recursion));
    let accurate = programs.find(|program| recursion.accepts(arm, program));
    accurate.unwrap_or_else(|| Program {
        is_plain: true,
        ..unsimplified(arm, &[plain_recursion(arm, &parts)])
    })
}

/// The program of a function in the plain gauge, as its recursion is written: long, and accurate. The rounding of
/// other programs is compared with it, and it is the result where every shorter program loses digits.
pub fn derive_plain(robot: &Robot, part: impl Into<function::Part>) -> Program {
    let arm = &Mechanism::from(robot);
    let part = Part::recursive(part);
    let gauge = match part.function.row().search {
        // Its recursion is written in this gauge in any case.
        Search::Accuracy => Gauge::physical(arm.joints.len()),
        _ => Gauge::plain(arm.joints.len()),
    };
    unsimplified(arm, &[Written::new(&[part], gauge)])
}

/// Functions as the recursions that are made for them, in the plain gauge. Bounds on the errors of
/// quotients of quotients say little: articulated bodies are measured by themselves.
fn plain_recursion(arm: &Mechanism, parts: &[Part]) -> Written {
    let recursion = |part: &Part| match part.form {
        Form::Articulated => *part,
        Form::Recursive | Form::Assembled | Form::Columns => Part {
            form: Form::Recursive,
            ..*part
        },
    };
    let parts: Vec<_> = parts.iter().map(recursion).collect();
    Written::new(&parts, Gauge::plain(arm.joints.len()))
}

/// The outputs of what is written, in that order.
fn outputs(symbols: &mut Symbols<'_>, written: &[Written]) -> Vec<Edge> {
    let written = written.iter();
    written
        .flat_map(|written| written.gauge.outputs(symbols, &written.parts))
        .collect()
}

/// The program of what is written, as the derivation writes it.
fn unsimplified(arm: &Mechanism, written: &[Written]) -> Program {
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, arm);
    let outputs = outputs(&mut symbols, written);
    Network::new(&graph, &outputs).program(symbols.meanings())
}

/// The program of what is written, shortened.
fn simplified(arm: &Mechanism, written: &[Written], recursion: &Recursion) -> Program {
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, arm);
    let outputs = outputs(&mut symbols, written);
    let mut network = Network::new(&graph, &outputs);
    let mut judge = recursion.judge(arm, &symbols, &network);
    // Branches of a base that moves meet in its equations.
    let groups = if arm.freedoms().has_base() {
        1
    } else {
        arm.groups().len()
    };
    let shorten = if groups > 1 { simplify_apart } else { simplify };
    let branches = arm.tree.tips().count().div_ceil(groups.max(1));
    shorten(&mut network, &mut judge, effort(written, branches.max(1)));
    network.program(symbols.meanings()).balanced()
}

/// The effort for one function, once for each; twice for torques along two velocities, of whose long programs
/// pairs of nodes would be left out. The work on a tree is that on an arm for each of its branches.
fn effort(written: &[Written], branches: usize) -> Effort {
    let parts = || written.iter().flat_map(|written| &written.parts);
    let is_mixed = parts().any(|part| part.function == Function::PassivityTorque);
    let times = if is_mixed { 2 * branches } else { branches };
    Effort {
        lookups: times * parts().count() * Effort::DEFAULT.lookups,
        pairs: times * Effort::DEFAULT.pairs,
    }
}
