//! The ranges of what a program reads, and the errors with which it is there.

use crate::interval::{Interval, Intervals};
use crate::mechanism::{Joint, Law, Mechanism};
use crate::robot::{Interpretation, Symbol, Value};
use crate::rounding::{Each, Ranged, Variables};

/// An input, as generated code has it; with an infinite error where nothing is known.
pub(super) fn input(arm: &Mechanism, symbol: &Symbol) -> Ranged {
    let one = || Interval::symmetric(1.0);
    match symbol {
        Symbol::Sine(i) => circle(position(arm, *i), |(sine, _)| sine),
        Symbol::Cosine(i) => circle(position(arm, *i), |(_, cosine)| cosine),
        Symbol::Position(i) => position(arm, *i),
        Symbol::Velocity(i) => moved(arm, *i, |_| one()),
        Symbol::Acceleration(_) | Symbol::Force(_) | Symbol::Entry(..) => Ranged::exact(one()),
        // The sign of a follower's velocity too, up to underflow.
        Symbol::VelocitySign(_) => Ranged::exact(one()),
        Symbol::Stribeck(i) => stribeck(arm, *i),
        Symbol::Pi | Symbol::Field(_) | Symbol::AngleSine(_) | Symbol::AngleCosine(_) => unknown(),
    }
}

fn unknown() -> Ranged {
    Ranged::with_error(Interval::symmetric(f64::INFINITY), [f64::INFINITY; 2])
}

/// A position or velocity; that of a follower is its leader's times the factor.
fn moved(arm: &Mechanism, index: usize, of_free: impl Fn(&Joint) -> Interval) -> Ranged {
    let joint = arm.joint_of_symbol(index);
    match &joint.law {
        Law::Following { coupling, .. } => {
            let leader = &arm.joints[coupling.leader];
            cell(&coupling.factor) * Ranged::exact(of_free(leader))
        }
        Law::Free { .. } | Law::Base { .. } | Law::Standing { .. } => Ranged::exact(of_free(joint)),
    }
}

/// A position: of a joint without limits, anywhere.
fn position(arm: &Mechanism, index: usize) -> Ranged {
    moved(arm, index, |joint| match &joint.limits {
        Some(limits) => {
            let [lower, upper] = limits.each_ref().map(|limit| Intervals.value(limit));
            lower.hull(upper)
        }
        None => Interval::symmetric(f64::INFINITY),
    })
}

/// The positions of all joints, on which inputs depend.
pub(super) struct Positions<'a> {
    pub(super) arm: &'a Mechanism,
    pub(super) symbols: &'a [Symbol],
}

impl Positions<'_> {
    fn is_free(&self, index: usize) -> bool {
        matches!(self.arm.joint_of_symbol(index).law, Law::Free { .. })
    }
}

impl Variables for Positions<'_> {
    /// Angles without limits are anywhere on a turn.
    fn whole(&self) -> Vec<Interval> {
        let range = |index: usize| {
            let range = position(self.arm, index).range;
            if range.size() < f64::INFINITY {
                range
            } else {
                Interval::symmetric(core::f64::consts::PI.next_up())
            }
        };
        (0..self.arm.free().count()).map(range).collect()
    }

    fn inputs(&self, ranges: &[Interval]) -> Vec<Ranged> {
        let of = |symbol: &Symbol| match symbol {
            Symbol::Sine(i) if self.is_free(*i) => {
                circle(Ranged::exact(ranges[*i]), |(sine, _)| sine)
            }
            Symbol::Cosine(i) if self.is_free(*i) => {
                circle(Ranged::exact(ranges[*i]), |(_, cosine)| cosine)
            }
            Symbol::Position(i)
                if input(self.arm, symbol).range.size() < f64::INFINITY && self.is_free(*i) =>
            {
                Ranged::exact(ranges[*i])
            }
            symbol => input(self.arm, symbol),
        };
        self.symbols.iter().map(of).collect()
    }

    fn of_input(&self, index: usize) -> Option<usize> {
        match &self.symbols[index] {
            Symbol::Sine(i) | Symbol::Cosine(i) | Symbol::Position(i) if self.is_free(*i) => {
                Some(*i)
            }
            _ => None,
        }
    }
}

/// A sine or a cosine: one unit in the last place of the largest, and what the angle is wrong by.
fn circle(angle: Ranged, pick: impl Fn((Interval, Interval)) -> Interval) -> Ranged {
    let range = pick(angle.range.sin_cos());
    // Only the cosine of zero is 1, and it is exact.
    let largest = range.size().min(1.0_f64.next_down());
    let single = (largest as f32).min(1.0_f32.next_down());
    let units = [
        largest.next_up() - largest,
        f64::from(single.next_up() - single),
    ];
    Ranged::with_error(range, wrong_by(angle.error, units))
}

/// Errors that are passed on, and others.
fn wrong_by(passed_on: Each, others: Each) -> Each {
    core::array::from_fn(|k| (passed_on[k] + others[k]).next_up())
}

/// exp(-(qd/v)^2).
///
/// With y' = y (1 + r) in place of y, |exp(-y') - exp(-y)| <= |r| y exp(-y (1 - |r|)), which is at most
/// |r| / (e (1 - |r|)), and less than |r| for small r.
fn stribeck(arm: &Mechanism, index: usize) -> Ranged {
    let range = Interval::new(0.0, 1.0);
    let Some(stribeck) = &arm.joint_of_symbol(index).forces.stribeck else {
        return unknown();
    };
    let velocity = relative(moved(arm, index, |_| Interval::exact(1.0)));
    let ratio = velocity / relative(cell(&stribeck.velocity));
    let r = (ratio * ratio)
        .error
        .map(|r| if r < 0.5 { r } else { f64::INFINITY });
    Ranged::with_error(range, wrong_by(r, [f64::EPSILON, f32::EPSILON.into()]))
}

/// The number over its exact value.
fn relative(x: Ranged) -> Ranged {
    let error = x.error.map(|error| match error {
        0.0 => 0.0,
        error => (error / x.range.least_size()).next_up(),
    });
    Ranged::with_error(Interval::exact(1.0), error)
}

/// A cell of the table as generated code evaluates it: its numbers rounded, and each operation.
fn cell(value: &Value) -> Ranged {
    match value {
        Value::Rational(x) => Ranged::rational(x, x.to_f64().value()),
        Value::Pi => Ranged::rounded(core::f64::consts::PI),
        Value::Field(_) => unknown(),
        Value::Neg(a) => -cell(a),
        Value::Add(a, b) => cell(a) + cell(b),
        Value::Mul(a, b) => cell(a) * cell(b),
        Value::Div(a, b) => cell(a) / cell(b),
    }
}
