//! The names of the variables of formulas.

use super::atom::{Atom, Run};
use super::entries::is_entry;
use super::expression::{Base, Expression, Factor};
use super::groups::{Groups, Member};
use crate::function::{Freedoms, plain};
use crate::robot::{Robot, Value};
use std::collections::BTreeSet;

/// The names of one arm.
pub(super) struct Names {
    /// The struct's fields, without `r#`; with `self.` in front of a name that an input has too.
    pub(super) fields: Vec<String>,
    pub(super) groups: Groups,
    pub(super) angles: Vec<Value>,
    pub(super) divisors: Vec<Expression>,
    /// The Stribeck velocities of the joints.
    pub(super) stribeck: Vec<Option<Value>>,
    /// Degrees of freedom of the base, and the joints.
    pub(super) freedoms: Freedoms,
    /// Whether c12 stands for cos(q1 + q2).
    pub(super) is_short: bool,
}

impl Names {
    pub(super) fn new(
        robot: &Robot,
        groups: Groups,
        angles: Vec<Value>,
        divisors: Vec<Expression>,
    ) -> Self {
        let freedoms = robot.freedoms();
        let fields = robot.fields.iter().map(|field| plain(field).to_owned());
        let fields: Vec<String> = fields.collect();
        let is_short = freedoms.joints < 10 && !fields.iter().any(|field| is_like_a_sine(field));
        let told_apart = |field: String| match is_entry(freedoms, &field) {
            true => format!("self.{field}"),
            false => field,
        };
        let stribeck = |row: &crate::robot::Row| Some(row.stribeck.as_ref()?.velocity.clone());
        Names {
            // Indices of two digits would run into each other.
            is_short,
            freedoms,
            fields: fields.into_iter().map(told_apart).collect(),
            groups,
            angles,
            divisors,
            stribeck: robot.joints().map(stribeck).collect(),
        }
    }

    /// The digits of a run where all its angles are added: 12 for q1 + q2.
    pub(super) fn digits(&self, run: Run) -> Option<String> {
        let members: Vec<Member> = self.groups.members(run).collect();
        let is_sum = members.iter().all(|member| !member.is_reversed);
        let number = |member: &Member| member.joint - self.freedoms.base + 1;
        let digits = members.iter().map(|member| number(member).to_string());
        (self.is_short && is_sum).then(|| digits.collect())
    }

    /// The positions of a run, each with whether it is subtracted.
    pub(super) fn terms(
        &self,
        run: Run,
        position: impl Fn(usize) -> String,
    ) -> Vec<(bool, String)> {
        let members = self.groups.members(run);
        members
            .map(|member| (member.is_reversed, position(member.joint)))
            .collect()
    }

    /// The sines and cosines in formulas, in order.
    pub(super) fn runs<'e>(
        &self,
        formulas: impl Iterator<Item = &'e Expression>,
    ) -> BTreeSet<(Run, Atom)> {
        let mut turning = BTreeSet::new();
        for formula in formulas {
            self.visit(formula, &mut |atom| match atom {
                Atom::Cosine(run) | Atom::Sine(run) => drop(turning.insert((run, atom))),
                _ => {}
            });
        }
        turning
    }

    fn visit(&self, formula: &Expression, found: &mut impl FnMut(Atom)) {
        let terms = formula.0.iter();
        let factors = terms.flat_map(|term| term.factors.iter().chain(&term.divisors));
        for Factor { base, .. } in factors {
            match base {
                Base::Sum(sum) => self.visit(sum, found),
                Base::Atom(Atom::Divisor(i)) => self.visit(&self.divisors[*i], found),
                Base::Atom(atom) => found(*atom),
            }
        }
    }
}

/// A field that is called as a sine, a position or a velocity would be.
fn is_like_a_sine(field: &str) -> bool {
    let digits = |prefix| field.strip_prefix(prefix);
    ["s", "c", "qdd", "qd", "q", "tau"]
        .into_iter()
        .filter_map(digits)
        .any(|rest| !rest.is_empty() && rest.bytes().all(|byte| byte.is_ascii_digit()))
}
