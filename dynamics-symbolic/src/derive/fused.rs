//! Several functions as one program.
//!
//! A quantity that their derivations have in common is one node of the graph, whoever writes it first. How many
//! there are depends on the gauge: one that is the shortest for all of them together shares the most,
//! but each of them may be longer in it than in its own. Both are derived, and the shorter is kept.

use super::functions::Part;
use super::gauge::Gauge;
use super::{Written, accurate};
use crate::function::{self, Form, Function};
use crate::mechanism::Mechanism;
use crate::program::Program;

/// The program of some functions: the outputs of one after those of the other.
pub(super) fn derive(arm: &Mechanism, parts: &[function::Part]) -> Program {
    let parts = together(arm, parts);
    let gauge = Gauge::search(arm, &parts);
    let in_one = accurate(arm, &[Written::new(&parts, gauge)]);
    let own = |part: &Part| Written::new(&[*part], Gauge::search(arm, &[*part]));
    let apart: Vec<_> = parts.iter().map(own).collect();
    let in_own = accurate(arm, &apart);
    let is_shorter = in_own.operations().total() < in_one.operations().total();
    if is_shorter { in_own } else { in_one }
}

/// The forms in which the functions are shortest together: each in turn takes another one where that
/// makes all of them shorter, in the plain gauge.
fn together(arm: &Mechanism, parts: &[function::Part]) -> Vec<Part> {
    let plain = Gauge::plain(arm.joints.len());
    let mut parts: Vec<_> = parts.iter().copied().map(Part::recursive).collect();
    let mut cost = plain.length(arm, &parts);
    for index in 0..parts.len() {
        for form in forms(arm, parts[index].function) {
            let before = parts[index];
            parts[index].form = form;
            let trial = plain.length(arm, &parts);
            if trial < cost {
                cost = trial;
            } else {
                parts[index] = before;
            }
        }
    }
    parts
}

/// The forms that a function may have beside others.
fn forms(arm: &Mechanism, function: Function) -> Vec<Form> {
    let mut forms = super::forms(arm, function);
    let by_bodies = [
        Function::GravityVector,
        Function::CoriolisVector,
        Function::BiasForce,
    ];
    if by_bodies.contains(&function) {
        forms.push(Form::Columns);
    }
    forms
}
