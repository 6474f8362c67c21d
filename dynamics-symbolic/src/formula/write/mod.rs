//! Formulas as text, LaTeX or MathML.

mod latex;
mod mathml;
mod notation;
mod number;

use super::atom::{Atom, Run};
use super::entries::{Letter, digits};
use super::expression::{Base, Expression, Factor, Number, Term};
use super::names::Names;
use crate::function::Argument;
use crate::robot::Value;
use latex::Latex;
use mathml::MathMl;
pub(crate) use notation::signed_sum;
use notation::{Notation, Text};
use number::Written;

/// How formulas are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// As plain text: `m2 l1 l2 c2`.
    Text,
    /// As LaTeX, for math mode.
    Latex,
    /// As a `math` element of MathML, which browsers show as it is.
    MathMl,
}

impl Format {
    fn notation(self) -> &'static dyn Notation {
        match self {
            Format::Text => &Text,
            Format::Latex => &Latex,
            Format::MathMl => &MathMl,
        }
    }
}

/// A formula in a format.
pub(super) fn written(format: Format, names: &Names, formula: &Expression) -> String {
    let to = format.notation();
    to.element(expression(to, names, formula))
}

/// The name of a value of a function: its letter and its indices.
pub(super) fn entry_name(format: Format, title: (&str, &[usize])) -> String {
    let to = format.notation();
    to.element(entry(to, title))
}

/// A value of a function and its formula as an equation.
pub(super) fn equation(
    format: Format,
    names: &Names,
    title: (&str, &[usize]),
    formula: &Expression,
) -> String {
    let to = format.notation();
    let sides = [entry(to, title), expression(to, names, formula)];
    to.element(sides.join(to.equals()))
}

/// The meaning of the short names of sines and cosines in some formulas.
pub(super) fn legend<'e>(
    names: &Names,
    formulas: impl Iterator<Item = &'e Expression>,
) -> Vec<String> {
    let line = |(run, atom): (Run, Atom)| {
        let (letter, function) = match atom {
            Atom::Sine(_) => ("s", "sin"),
            _ => ("c", "cos"),
        };
        let digits = names.digits(run)?;
        let sum = Text.sum(&names.terms(run, |joint| position(&Text, names, joint)));
        Some(format!("{letter}{digits} = {function}({sum})"))
    };
    names.runs(formulas).into_iter().filter_map(line).collect()
}

fn entry(to: &dyn Notation, (symbol, indices): (&str, &[usize])) -> String {
    let digits = digits(indices);
    to.letter(&format!("{symbol}{digits}"), symbol, 0, &digits)
}

fn expression(to: &dyn Notation, names: &Names, sum: &Expression) -> String {
    let summands = sum.0.iter();
    let terms = summands.map(|summand| (summand.is_negative, term(to, names, summand)));
    match &terms.collect::<Vec<_>>()[..] {
        [] => to.number(&Written::integer(0)),
        terms => to.sum(terms),
    }
}

/// Without its sign.
fn term(to: &dyn Notation, names: &Names, term: &Term) -> String {
    let write = |factors: &[Factor]| -> Vec<String> {
        factors.iter().map(|f| factor(to, names, f)).collect()
    };
    let mut factors = write(&term.factors);
    if term.number != Number::ONE || factors.is_empty() {
        factors.insert(0, to.number(&Written::new(&term.number)));
    }
    let divisors = write(&term.divisors);
    let dividend = to.product(&factors);
    match divisors.len() {
        0 => dividend,
        count => to.quotient(&dividend, &to.product(&divisors), count == 1),
    }
}

fn factor(to: &dyn Notation, names: &Names, factor: &Factor) -> String {
    let base = match &factor.base {
        Base::Atom(Atom::Divisor(i)) => to.parentheses(&expression(to, names, &names.divisors[*i])),
        Base::Atom(variable) => atom(to, names, *variable),
        Base::Sum(sum) => to.parentheses(&expression(to, names, sum)),
    };
    match factor.exponent {
        1 => base,
        exponent => to.power(&base, exponent),
    }
}

fn atom(to: &dyn Notation, names: &Names, atom: Atom) -> String {
    match atom {
        Atom::Pi => to.letter("pi", "pi", 0, ""),
        Atom::Field(i) => field(to, &names.fields[i]),
        Atom::AngleCosine(i) => to.call("cos", &value(to, names, &names.angles[i])),
        Atom::AngleSine(i) => to.call("sin", &value(to, names, &names.angles[i])),
        Atom::Divisor(i) => expression(to, names, &names.divisors[i]),
        Atom::Position(i) => position(to, names, i),
        Atom::Velocity(i) => joint(to, names, Argument::Velocity, i),
        Atom::Acceleration(i) => joint(to, names, Argument::Acceleration, i),
        Atom::Force(i) => joint(to, names, Argument::Force, i),
        Atom::Entry(argument, i) => joint(to, names, argument, i),
        Atom::Cosine(run) => turn(to, names, "c", "cos", run),
        Atom::Sine(run) => turn(to, names, "s", "sin", run),
        Atom::VelocitySign(i) => to.call("sign", &joint(to, names, Argument::Velocity, i)),
        Atom::Stribeck(i) => stribeck(to, names, i),
    }
}

fn turn(to: &dyn Notation, names: &Names, letter: &str, function: &str, run: Run) -> String {
    match names.digits(run) {
        Some(digits) => to.letter(&format!("{letter}{digits}"), letter, 0, &digits),
        None => {
            let terms = names.terms(run, |index| position(to, names, index));
            to.call(function, &to.sum(&terms))
        }
    }
}

/// exp(-(qd / v)^2)
fn stribeck(to: &dyn Notation, names: &Names, index: usize) -> String {
    let v = match &names.stribeck[index - names.freedoms.base] {
        Some(velocity) => value(to, names, velocity),
        None => to.number(&Written::integer(1)),
    };
    let qd = joint(to, names, Argument::Velocity, index);
    let ratio = to.quotient(&qd, &to.parentheses(&v), true);
    let square = to.power(&to.parentheses(&ratio), 2);
    to.call("exp", &to.sum(&[(true, square)]))
}

/// A cell of the table.
fn value(to: &dyn Notation, names: &Names, value: &Value) -> String {
    expression(to, names, &Expression::of_value(value))
}

/// An entry of an argument.
fn joint(to: &dyn Notation, names: &Names, argument: Argument, index: usize) -> String {
    let letter = Letter::new(names.freedoms, argument, index);
    to.letter(&letter.text, letter.base, letter.dots, &letter.subscript)
}

/// The position of a joint, which is counted behind the degrees of freedom of a base that moves.
fn position(to: &dyn Notation, names: &Names, freedom: usize) -> String {
    joint(to, names, Argument::Position, freedom - names.freedoms.base)
}

/// A field: digits at its end and what follows the first underscore are a subscript.
fn field(to: &dyn Notation, name: &str) -> String {
    let digits = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let (base, subscript) = match name.split_once('_') {
        Some((base, rest)) if !base.is_empty() => (base, rest.replace('_', ",")),
        _ if digits.is_empty() => (name, String::new()),
        _ => (digits, name[digits.len()..].to_owned()),
    };
    to.letter(name, base, 0, &subscript)
}
