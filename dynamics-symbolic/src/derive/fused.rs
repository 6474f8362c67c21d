//! Several functions as one program.
//!
//! A quantity that their derivations have in common is one node of the graph, whoever writes it first. How many
//! there are depends on the gauge: one that is the shortest for all of them together shares the most,
//! but each of them may be longer in it than in its own. Both are derived, and the shorter is kept.
//!
//! One program of several functions: the outputs of the parts one after the other, on one graph, on which common
//! terms of two parts are one node. Two programs are made, one in a gauge that is searched for all parts together,
//! one with each part in its own gauge. The shorter is kept. Each part is proven by its own definition, and its
//! rounding is compared with its own plain recursion, so that no part loses digits for another.
//!
//! Beyond sines, the shortest ways to M and to V share little except sums of angles: M turns composite bodies
//! inwards, V reads the constant ones of the links. V may also be written by composite bodies
//! (`composite::bias_force`), which is shorter beside M where every composite body has all of its parameters. Gravity
//! is nearly free beside M, because an acceleration -g of the base acts on joint j as -g times the force of M's
//! column j. The torque is nearly free beside its derivatives, whose recursion sums the same wrenches.
//! `tests/suite/fused.rs` has the operations of six arms.

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
